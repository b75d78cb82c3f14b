// How the page "Review" is put together.
#include <QHBoxLayout>
#include <QSplitter>
#include <QVBoxLayout>

#include "app/console/review_page.h"
#include "widgets/icon.h"
#include "widgets/number_text.h"

namespace fyd::console {
namespace {

using widgets::kGrid;

constexpr int kSideWidth = 30 * kGrid;

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
      list_(new SessionList(context.catalogue, this)),
      overview_(new widgets::SessionOverview(this)),
      curves_(new ReviewCurves(this)),
      curve_tools_(new CurveTools(curves_->stack(), context.tell, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(stack_);
  stack_->addWidget(panel(list_, this));
  stack_->addWidget(buildReview());
  connect(list_, &SessionList::openAsked, this, &ReviewPage::open);
  connectCursor();
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
  body->addWidget(panel(curves, review), 1);
  body->addWidget(buildRight());
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
  play_ = new QToolButton(bar);
  play_->setObjectName(QStringLiteral("play_button"));
  play_->setText(tr("Play"));
  play_->setToolTip(tr("Play or pause (Space)"));
  connect(play_, &QToolButton::clicked, &player_, &ReviewPlayer::togglePlaying);
  connect(&player_, &ReviewPlayer::playingChanged, this,
          [this](bool playing) { play_->setText(playing ? tr("Pause") : tr("Play")); });
  speed_ = new QComboBox(bar);
  speed_->setObjectName(QStringLiteral("play_speed"));
  speed_->setAccessibleName(tr("Speed of playing"));
  for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
    speed_->addItem(tr("%1 ×").arg(widgets::plainNumber(speed)), speed);
  }
  speed_->setCurrentIndex(3);
  connect(speed_, &QComboBox::currentIndexChanged, this,
          [this](int index) { player_.setSpeed(speed_->itemData(index).toDouble()); });
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
  layout->addWidget(play_);
  layout->addWidget(speed_);
  layout->addWidget(time_);
  layout->addWidget(title_, 1);
  return bar;
}

QWidget* ReviewPage::buildLeft() {
  auto* left = new QFrame(this);
  left->setProperty("surface", "panel");
  left->setFixedWidth(kSideWidth);
  auto* layout = new QVBoxLayout(left);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  camera_ = new widgets::CameraImage(left);
  camera_->setEmptyText(tr("No picture at the cursor."));
  camera_words_ = new QLabel(left);
  camera_words_->setWordWrap(true);
  note_table_ = new NoteTable(left);
  note_field_ = new QLineEdit(left);
  note_field_->setObjectName(QStringLiteral("note_field"));
  note_field_->setMaxLength(1000);
  note_field_->setPlaceholderText(tr("Note at the cursor, then Enter"));
  note_field_->setAccessibleName(tr("Note at the cursor"));
  connect(note_field_, &QLineEdit::returnPressed, this,
          [this] { writeNote(session::NoteKind::note, note_field_->text()); });
  layout->addWidget(camera_);
  layout->addWidget(camera_words_);
  layout->addWidget(note_table_, 1);
  layout->addWidget(note_field_);
  return left;
}

QWidget* ReviewPage::buildRight() {
  tabs_ = new QTabWidget(this);
  tabs_->setFixedWidth(kSideWidth + 6 * kGrid);
  tabs_->setDocumentMode(true);
  touch_table_ = new TouchTable(tabs_);
  figures_table_ = new FiguresTable(tabs_);
  what_if_ = new WhatIfPanel(tabs_);
  tabs_->addTab(touch_table_, tr("Touches"));
  tabs_->addTab(figures_table_, tr("A – B"));
  tabs_->addTab(what_if_, tr("What if"));
  tabs_->addTab(buildCompare(), tr("Compare"));
  return tabs_;
}

QWidget* ReviewPage::buildCompare() {
  auto* page = new QWidget(this);
  auto* layout = new QVBoxLayout(page);
  layout->setSpacing(kGrid);
  compare_path_ = new QLineEdit(page);
  compare_path_->setObjectName(QStringLiteral("compare_path"));
  compare_path_->setPlaceholderText(tr("Path of a second recording, then Enter"));
  compare_path_->setAccessibleName(tr("Path of a second recording"));
  connect(compare_path_, &QLineEdit::returnPressed, this, [this] { compare(compare_path_->text()); });
  our_touch_ = new QComboBox(page);
  our_touch_->setAccessibleName(tr("Align this session at"));
  their_touch_ = new QComboBox(page);
  their_touch_->setAccessibleName(tr("Align the other session at"));
  compare_words_ = new QLabel(page);
  compare_words_->setWordWrap(true);
  for (QComboBox* box : {our_touch_, their_touch_}) {
    connect(box, &QComboBox::currentIndexChanged, this,
            [this] { alignAt(our_touch_->currentIndex() - 1, their_touch_->currentIndex() - 1); });
  }
  layout->addWidget(compare_path_);
  layout->addWidget(new QLabel(tr("This session's"), page));
  layout->addWidget(our_touch_);
  layout->addWidget(new QLabel(tr("lies on the other's"), page));
  layout->addWidget(their_touch_);
  layout->addWidget(compare_words_);
  layout->addStretch(1);
  return page;
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
  connect(touch_table_, &TouchTable::touchChosen, this, [this](double start_s, double end_s) {
    constexpr double kAround_s = 0.5;
    curves_->show(start_s - kAround_s, end_s + kAround_s);
    player_.goTo(start_s);
  });
  connect(what_if_, &WhatIfPanel::replayed, this, [this](std::shared_ptr<const widgets::CurveBuffer> curves) {
    curves_->source().setWhatIf(std::move(curves));
    curves_->redrawSoon();
  });
}

}  // namespace fyd::console
