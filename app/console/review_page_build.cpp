// How the page "Review" is put together.
#include <QComboBox>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/console/review_page.h"
#include "widgets/icon.h"
#include "widgets/number_text.h"

namespace fyd::console {
namespace {

using widgets::kGrid;

constexpr int kSideWidth = 30 * kGrid;
constexpr int kTabsAtLeast = 36 * kGrid;
constexpr int kTabsAtMost = 50 * kGrid;  // every column of the touches

QFrame* panel(QWidget* inside, QWidget* parent) {
  auto* frame = new QFrame(parent);
  frame->setProperty("surface", "panel");
  auto* layout = new QVBoxLayout(frame);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(inside);
  return frame;
}

}  // namespace

ReviewPage::ReviewPage(const PageContext& context, QWidget* parent)
    : Page(parent),
      context_(context),
      stack_(new QStackedWidget(this)),
      work_(
          new widgets::WorkBars(QKeySequence(QLatin1String(kCancelWorkKeys)).toString(QKeySequence::NativeText), this)),
      list_(new SessionList(context.catalogue, this)),
      overview_(new widgets::SessionOverview(this)),
      curves_(new ReviewCurves(this)),
      curve_tools_(new CurveTools(curves_->stack(), context.tell, this)),
      exports_(new ReviewExports(work_, context.tell, this)),
      recovery_(new ReviewRecovery(work_, context.catalogue, context.tell, this)),
      note_table_(new NoteTable(this)),
      marks_(overview_, note_table_, context.tell),
      touch_search_(work_),
      figures_work_(work_) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid / 2);
  layout->addWidget(stack_, 1);
  layout->addWidget(work_);
  stack_->addWidget(panel(list_, this));
  stack_->addWidget(buildReview());
  connect(list_, &SessionList::openAsked, this, &ReviewPage::open);
  connectCursor();
  connectTabs();
  connectRecovery();
}

QWidget* ReviewPage::buildReview() {
  auto* review = new QWidget(this);
  auto* layout = new QVBoxLayout(review);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  layout->addWidget(buildBar());
  layout->addWidget(panel(overview_, review));
  auto* body = new QHBoxLayout;
  body->setSpacing(kGrid);
  body->addWidget(buildLeft());
  auto* curves = new QWidget(review);
  auto* beside = new QHBoxLayout(curves);
  beside->setContentsMargins(0, 0, 0, 0);
  beside->setSpacing(0);
  auto* pictures = new QVBoxLayout;
  pictures->setSpacing(0);
  pictures->addWidget(curves_, 2);
  pictures->addWidget(curve_tools_->spectrum(), 1);
  beside->addLayout(pictures, 1);
  beside->addWidget(curve_tools_->panel());
  body->addWidget(panel(curves, review), 5);
  body->addWidget(buildRight(), 3);
  layout->addLayout(body, 1);
  return review;
}

QWidget* ReviewPage::buildBar() {
  auto* bar = new QWidget(this);
  auto* layout = bar_ = new QHBoxLayout(bar);
  layout->setContentsMargins(kGrid, 0, kGrid, 0);
  layout->setSpacing(kGrid);
  auto* back = new QToolButton(bar);
  back->setText(tr("Sessions"));
  back->setToolTip(tr("The list of sessions (Ctrl+O)"));
  connect(back, &QToolButton::clicked, this, &ReviewPage::showList);
  auto* play = new QToolButton(bar);
  play->setObjectName(QStringLiteral("play_button"));
  play->setText(tr("Play"));
  play->setToolTip(tr("Play or pause (Space)"));
  connect(play, &QToolButton::clicked, &player_, &ReviewPlayer::togglePlaying);
  connect(&player_, &ReviewPlayer::playingChanged, play,
          [play](bool playing) { play->setText(playing ? tr("Pause") : tr("Play")); });
  auto* chosen_speed = new QComboBox(bar);
  chosen_speed->setObjectName(QStringLiteral("play_speed"));
  chosen_speed->setAccessibleName(tr("Speed of playing"));
  for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
    chosen_speed->addItem(tr("%1 ×").arg(widgets::plainNumber(speed)), speed);
  }
  chosen_speed->setCurrentIndex(3);
  connect(chosen_speed, &QComboBox::currentIndexChanged, this,
          [this, chosen_speed](int index) { player_.setSpeed(chosen_speed->itemData(index).toDouble()); });
  time_ = new QLabel(bar);
  time_->setAccessibleName(tr("Cursor"));
  time_->setMinimumWidth(10 * kGrid);
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  title_ = new QLabel(bar);
  title_->setObjectName(QStringLiteral("review_title"));
  title_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  title_->setMinimumWidth(0);
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  layout->addWidget(back);
  layout->addWidget(play);
  layout->addWidget(chosen_speed);
  layout->addWidget(time_);
  layout->addWidget(title_, 1);
  recover_ = new QToolButton(bar);
  recover_->setObjectName(QStringLiteral("recover_button"));
  recover_->setText(tr("Recover"));
  recover_->setToolTip(
      tr("Its recorder crashed, or it is damaged; what can be proven is shown. This makes the recording whole. Nothing "
         "is deleted."));
  recover_->setProperty("role", "warning");
  recover_->hide();
  layout->addWidget(recover_);
  return bar;
}

QWidget* ReviewPage::buildLeft() {
  auto* left = new QFrame(this);
  left->setProperty("surface", "panel");
  left->setFixedWidth(kSideWidth);
  auto* layout = new QVBoxLayout(left);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  camera_ = new ReviewCamera(left);
  note_field_ = new QLineEdit(left);
  note_field_->setObjectName(QStringLiteral("note_field"));
  note_field_->setMaxLength(1000);
  note_field_->setPlaceholderText(tr("Note at the cursor, then Enter"));
  note_field_->setAccessibleName(tr("Note at the cursor"));
  connect(note_field_, &QLineEdit::returnPressed, this,
          [this] { writeNote(session::NoteKind::note, note_field_->text()); });
  layout->addWidget(camera_);
  layout->addWidget(note_table_, 1);
  layout->addWidget(note_field_);
  return left;
}

QWidget* ReviewPage::buildRight() {
  tabs_ = new QTabWidget(this);
  tabs_->setMinimumWidth(kTabsAtLeast);
  tabs_->setMaximumWidth(kTabsAtMost);
  tabs_->setDocumentMode(true);
  touch_table_ = new TouchTable(tabs_);
  figures_table_ = new FiguresTable(tabs_);
  what_if_ = new WhatIfPanel(work_, tabs_);
  comparison_ = new ReviewComparison(work_, tabs_);
  auto* touches = new QWidget(tabs_);
  auto* layout = new QVBoxLayout(touches);
  layout->setContentsMargins(0, 0, 0, kGrid);
  layout->setSpacing(kGrid);
  layout->addWidget(touch_table_, 1);
  card_ = new QToolButton(touches);
  card_->setObjectName(QStringLiteral("card_button"));
  card_->setText(tr("Make a gesture card of this touch"));
  card_->setToolTip(tr("A small file beside the recording, which the simulated finger plays (G)"));
  card_->setEnabled(false);
  connect(card_, &QToolButton::clicked, this, &ReviewPage::makeCard);
  connect(touch_table_, &QTableWidget::currentCellChanged, this,
          [this] { card_->setEnabled(touch_table_->chosen() != nullptr); });
  layout->addWidget(card_, 0, Qt::AlignHCenter);
  tabs_->addTab(touches, tr("Touches"));
  tabs_->addTab(figures_table_, tr("A – B"));
  tabs_->addTab(what_if_, tr("What if"));
  tabs_->addTab(comparison_, tr("Compare"));
  return tabs_;
}

void ReviewPage::connectCursor() {
  connect(&player_, &ReviewPlayer::moved, this, &ReviewPage::look);
  connect(curves_, &ReviewCurves::cursorAsked, &player_, &ReviewPlayer::goTo);
  connect(curves_, &ReviewCurves::windowShown, overview_, &widgets::SessionOverview::setWindow);
  widgets::SpectrumView* spectrum = curve_tools_->spectrum();
  const auto draw = [this, spectrum](bool even_soon) {
    spectrum->draw(curves_->source(), curves_->window(), even_soon);
  };
  connect(curves_, &ReviewCurves::drawn, spectrum, [draw] { draw(false); });
  connect(spectrum, &widgets::SpectrumView::changed, spectrum, [draw] { draw(true); });
  connect(curves_, &ReviewCurves::problem, this,
          [this](const QString& text) { context_.tell(widgets::Severity::warning, text); });
  connect(overview_, &widgets::SessionOverview::cursorAsked, &player_, &ReviewPlayer::goTo);
  connect(overview_, &widgets::SessionOverview::windowAsked, curves_, &ReviewCurves::show);
  connect(overview_, &widgets::SessionOverview::resized, this, &ReviewPage::showEnvelope);
  connect(note_table_, &NoteTable::noteChosen, &player_, &ReviewPlayer::goTo);
}

void ReviewPage::connectTabs() {
  connect(touch_table_, &TouchTable::touchChosen, this, [this](double start_s, double end_s) {
    constexpr double kAround_s = 0.5;
    curves_->show(start_s - kAround_s, end_s + kAround_s);
    player_.goTo(start_s);
  });
  connect(what_if_, &WhatIfPanel::replayed, this, [this](std::shared_ptr<const widgets::CurveBuffer> curves) {
    curves_->source().setWhatIf(std::move(curves));
    curves_->redrawSoon();
  });
  connect(comparison_, &ReviewComparison::otherChanged, this,
          [this](const session::Recording* other, double later_by_s) {
            curves_->source().setOther(other, later_by_s);
            curves_->redrawSoon();
          });
}

void ReviewPage::connectRecovery() {
  connect(recover_, &QToolButton::clicked, this, [this] { recovery_->recover(path_); });
  connect(list_, &SessionList::recoverAsked, recovery_, &ReviewRecovery::recover);
  connect(recovery_, &ReviewRecovery::recovered, this, [this](const QString& asked, const QString& file) {
    if (!showsList() && asked == path_) {
      open(file);
    } else {
      list_->look();
    }
  });
}

}  // namespace fyd::console
