#include "app/console/review/review_page.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/console/shell/curve_limits.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/reader/recorded_profile.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::console {
namespace {

using widgets::kGrid;

constexpr const char* kMenu = QT_TRANSLATE_NOOP("Commands", "Review");
constexpr int kSideWidth = 30 * kGrid;

using Mark = widgets::CurveStack::Mark;
using widgets::Severity;

QString wholenessWords(const recording::RecordingInfo& info) {
  switch (info.wholeness) {
    case recording::Wholeness::whole: break;
    case recording::Wholeness::growing: return ReviewPage::tr("still being recorded");
    case recording::Wholeness::crashed: return ReviewPage::tr("recorder crashed");
    case recording::Wholeness::damaged: return ReviewPage::tr("damaged");
  }
  if (info.gaps > 0) return ReviewPage::tr("%n sample(s) lost", nullptr, static_cast<int>(info.gaps));
  return info.header.missing.empty() ? ReviewPage::tr("whole") : ReviewPage::tr("parts missing");
}

/// By which it is found now and later: one that is being recorded loses its ".partial" when it is closed.
QString lastingName(const QString& path, const recording::RecordingInfo& info) {
  const std::string whole = recording::wholeOf(path.toStdString());
  const bool loses =
      info.wholeness == recording::Wholeness::growing && !QFileInfo::exists(QString::fromStdString(whole));
  return loses ? QString::fromStdString(whole) : path;
}

bool canBeRecovered(const recording::RecordingInfo& info) {
  return info.wholeness == recording::Wholeness::crashed || info.wholeness == recording::Wholeness::damaged;
}

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
      work_(new widgets::ProgressBars(QKeySequence(QLatin1String(kCancelWorkKeys)).toString(QKeySequence::NativeText),
                                      this)),
      list_(new SessionList(context.catalogue, recent_, this)),
      overview_(new widgets::SessionOverview(this)),
      curves_(new ReviewCurves(this)),
      curve_tools_(new CurveTools(curves_->stack(), context.tell, this)),
      exports_(new ReviewExports(work_, context.tell, this)),
      recovery_(new ReviewRecovery(work_, context.catalogue, context.tell, this)),
      note_table_(new NoteTable(this)),
      marks_(overview_, note_table_, context.catalogue, context.tell),
      bar_(new ReviewBar(player_, this)),
      camera_(new ReviewCamera(this)),
      note_field_(new QLineEdit(this)),
      tags_field_(new QLineEdit(this)),
      tabs_(new ReviewTabs(context, work_, exports_, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid / 2);
  layout->addWidget(stack_, 1);
  layout->addWidget(work_);
  stack_->addWidget(panel(list_, this));
  stack_->addWidget(buildReview());
  showPart(0);
  connect(list_, &SessionList::openAsked, this, &ReviewPage::open);
  connect(list_, &SessionList::compareAsked, this, &ReviewPage::compare);
  bar_->timeField()->setSpan(
      [this] { return std::pair(0.0, recording_ ? recording_->info().duration_s : std::nan("")); });
  connect(bar_->timeField(), &widgets::TimeField::asked, this, &ReviewPage::goTo);
  connect(bar_, &ReviewBar::listAsked, this, &ReviewPage::showList);
  connectCursor();
  connectTabs();
  connectRecovery();
}

QWidget* ReviewPage::buildReview() {
  auto* review = new QWidget(this);
  auto* layout = new QVBoxLayout(review);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  layout->addWidget(bar_);
  layout->addWidget(panel(overview_, review));
  auto* body = new QHBoxLayout;
  body->setSpacing(kGrid);
  body->addWidget(buildLeft(), 2);
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
  body->addWidget(tabs_, 3);
  layout->addLayout(body, 1);
  return review;
}

QWidget* ReviewPage::buildLeft() {
  auto* left = new QFrame(this);
  left->setProperty("surface", "panel");
  left->setMinimumWidth(kSideWidth);
  left->setMaximumWidth(3 * kSideWidth);  // a wide window gives the picture room
  auto* layout = new QVBoxLayout(left);
  layout->setContentsMargins(kGrid, kGrid, kGrid, kGrid);
  layout->setSpacing(kGrid);
  note_field_->setObjectName(QStringLiteral("note_field"));
  note_field_->setMaxLength(1000);
  note_field_->setPlaceholderText(tr("Note at the cursor, then Enter"));
  note_field_->setAccessibleName(tr("Note at the cursor"));
  connect(note_field_, &QLineEdit::returnPressed, this,
          [this] { writeNote(recording::NoteKind::note, note_field_->text()); });
  layout->addWidget(camera_);
  layout->addWidget(note_table_, 1);
  layout->addWidget(note_field_);
  tags_field_->setObjectName(QStringLiteral("tags_field"));
  tags_field_->setPlaceholderText(tr("Tags, commas between, then Enter"));
  tags_field_->setAccessibleName(tr("Tags of the session"));
  tags_field_->setToolTip(tr("Kept beside the recording, which stays as it is; the list of sessions finds them."));
  connect(tags_field_, &QLineEdit::returnPressed, this, &ReviewPage::writeTags);
  auto* tags = new QHBoxLayout;
  auto* word = new QLabel(tr("Tags"), left);
  word->setBuddy(tags_field_);
  tags->addWidget(word);
  tags->addWidget(tags_field_, 1);
  layout->addLayout(tags);
  return left;
}

void ReviewPage::connectCursor() {
  connect(&player_, &ReviewPlayer::moved, this, &ReviewPage::look);
  connect(curves_, &ReviewCurves::cursorAsked, this, &ReviewPage::goTo);
  connect(curves_, &ReviewCurves::windowShown, overview_, &widgets::SessionOverview::setWindow);
  widgets::SpectrumView* spectrum = curve_tools_->spectrum();
  const auto draw = [this, spectrum](bool even_soon) {
    spectrum->draw(curves_->source(), curves_->window(), even_soon);
  };
  connect(curves_, &ReviewCurves::drawn, spectrum, [draw] { draw(false); });
  connect(spectrum, &widgets::SpectrumView::changed, spectrum, [draw] { draw(true); });
  connect(curves_, &ReviewCurves::problem, this,
          [this](const QString& text) { context_.tell(widgets::Severity::warning, text); });
  connect(overview_, &widgets::SessionOverview::cursorAsked, this, &ReviewPage::goTo);
  connect(overview_, &widgets::SessionOverview::windowAsked, curves_, &ReviewCurves::show);
  connect(overview_, &widgets::SessionOverview::resized, this, &ReviewPage::showEnvelope);
  connect(note_table_, &NoteTable::noteChosen, &player_, &ReviewPlayer::goTo);
}

void ReviewPage::connectTabs() {
  connect(tabs_, &ReviewTabs::touchesChanged, overview_, [this](const std::vector<exports::Touch>& touches) {
    std::vector<std::pair<double, double>> bars;
    bars.reserve(touches.size());
    for (const exports::Touch& touch : touches) bars.emplace_back(touch.start_s, touch.end_s);
    overview_->setTouches(std::move(bars));
  });
  connect(tabs_->touches(), &TouchTable::touchChosen, this, [this](double start_s, double end_s) {
    constexpr double kAround_s = 0.5;
    curves_->show(start_s - kAround_s, end_s + kAround_s);
    player_.goTo(start_s);
  });
  connect(tabs_->whatIf(), &WhatIfPanel::replayed, this, [this](std::shared_ptr<const widgets::CurveBuffer> curves) {
    curves_->source().setWhatIf(std::move(curves));
    curves_->redrawSoon();
  });
  connect(tabs_->comparison(), &ReviewComparison::otherChanged, this,
          [this](const recording::Recording* other, double later_by_s) {
            curves_->source().setOther(other, later_by_s);
            curves_->redrawSoon();
          });
}

void ReviewPage::connectRecovery() {
  connect(bar_->recoverButton(), &QToolButton::clicked, this, [this] { recovery_->recover(shown_.path); });
  connect(list_, &SessionList::recoverAsked, recovery_, &ReviewRecovery::recover);
  connect(recovery_, &ReviewRecovery::recovered, this, [this](const QString& asked, const QString& file) {
    if (!showsList() && asked == shown_.path) {
      open(file);
    } else {
      list_->look();
    }
  });
}

ReviewPage::~ReviewPage() {
  // All are asked to stop before the first is waited for.
  exports_->drop();
  recovery_->drop();
  close();
}

void ReviewPage::enter() {
  if (showsList()) list_->look();
  if (recording_ && recording_->info().wholeness == recording::Wholeness::growing) {
    if (const auto news = recording_->refresh(); news && *news) showGrowth();
  }
}

void ReviewPage::showGrowth() {
  describe();
  marks_.show(*recording_);
  showEnvelope();
  curves_->redrawSoon();
  tabs_->findTouches();
}

QString ReviewPage::unfinished() const {
  const QStringList files = exports_->underWay();
  return files.isEmpty() ? QString() : tr("being written: %1").arg(files.join(QStringLiteral(", ")));
}

void ReviewPage::leave() { player_.stop(); }

/// Only the shown one claims its size, so that the list needs no scrolling in a window that is too low for a review.
void ReviewPage::showPart(int index) {
  for (int i = 0; i < stack_->count(); ++i) {
    const auto policy = i == index ? QSizePolicy::Preferred : QSizePolicy::Ignored;
    stack_->widget(i)->setSizePolicy(policy, policy);
  }
  stack_->setCurrentIndex(index);
  offerCommands();
}

void ReviewPage::offerCommands() {
  for (QAction* each : recording_commands_) each->setEnabled(!showsList());
}

void ReviewPage::showList() {
  player_.stop();
  showPart(0);
  list_->look();
}

void ReviewPage::showNews() {
  if (isVisible() && showsList()) list_->look();
}

void ReviewPage::close() {
  tabs_->close();
  player_.setRecording(nullptr);
  exports_->setRecording({});
  curves_->source() = ReviewSource();
  recording_.reset();
  camera_->forget();
}

bool ReviewPage::open(const QString& path) {
  auto opened = recording::Recording::open(path.toStdString());
  if (!opened) {
    const QString why = widgets::coreText(opened.error().message);
    showsList() ? list_->sayProblem(why) : context_.tell(Severity::warning, why);
    return false;
  }
  close();
  recording_ = std::move(*opened);
  shown_ = {.path = lastingName(path, recording_->info()), .id = recording_->info().header.id};
  recent_.add(shown_.path);
  exports_->setRecording(shown_);
  curve_tools_->saver().setFolder(QFileInfo(shown_.path).absolutePath());
  curve_tools_->saver().setStem(QFileInfo(shown_.path).completeBaseName() + tr(" curves"));
  const double duration_s = recording_->info().duration_s;
  curves_->source().setSession(recording_.get());
  curves_->setDuration(duration_s);
  curves_->stack()->clearMarks();
  if (const auto felt = recording::recordedParameters(recording_->info().header)) drawLimits(*curves_->stack(), *felt);
  tabs_->open(shown_);
  marks_.open(shown_);
  note_field_->clear();  // a note that could not be written was the former recording's
  describe();
  marks_.show(*recording_);
  showTags();
  showPart(1);
  player_.setRecording(recording_.get());
  curves_->show(0.0, std::min(duration_s, 30.0));
  showEnvelope();
  curves_->setFocus();
  return true;
}

void ReviewPage::compare(const QString& first, const QString& second) {
  if (!open(first)) return;
  tabs_->setCurrentWidget(tabs_->comparison());
  tabs_->comparison()->compare(second);
}

void ReviewPage::describe() {
  const recording::RecordingInfo& info = recording_->info();
  // The most important comes first, because a narrow window cuts the rest.
  QStringList words = {
      QFileInfo(shown_.path).fileName(), wholenessWords(info),
      QString::fromStdString(info.header.started_utc).left(19).replace(QLatin1Char('T'), QLatin1Char(' ')) + tr(" UTC"),
      widgets::durationText(info.duration_s)};
  if (!info.header.subject.empty()) words << tr("subject %1").arg(QString::fromStdString(info.header.subject));
  if (!info.header.operator_name.empty()) words << tr("by %1").arg(QString::fromStdString(info.header.operator_name));
  bar_->recoverButton()->setVisible(canBeRecovered(info));
  bar_->setTitle(words.join(QStringLiteral(" · ")));
  overview_->setDuration(info.duration_s);
  curves_->setDuration(info.duration_s);
}

void ReviewPage::showEnvelope() {
  if (!recording_) return;
  std::vector<widgets::CurveColumn> columns;
  curves_->source().decimate(ReviewSource::channel(ReviewLayer::session, 0), 0.0, recording_->info().duration_s,
                             static_cast<std::size_t>(overview_->plotWidth_px()), columns);
  overview_->setEnvelope(std::move(columns), widgets::Quantity::force);
}

void ReviewPage::look(double time_s) {
  overview_->setCursor_s(time_s);
  curves_->setCursor_s(time_s);
  bar_->setTime(time_s);
  camera_->showAt(recording_.get(), time_s);
}

void ReviewPage::goTo(double time_s) {
  curves_->setFocus();  // the keys of the place work again
  player_.goTo(time_s);
}

void ReviewPage::setMark(Mark which) {
  if (!recording_) return;
  curves_->stack()->setMark(which, player_.time_s());
  showMarks();
  tabs_->showFigures(curves_->stack()->mark_s(Mark::a), curves_->stack()->mark_s(Mark::b));
}

void ReviewPage::showMarks() {
  tabs_->exportPanel()->setMarks(curves_->stack()->mark_s(Mark::a), curves_->stack()->mark_s(Mark::b));
}

void ReviewPage::writeNote(recording::NoteKind kind, const QString& text) {
  if (!recording_ || !marks_.write(kind, text, player_.time_s())) return;
  note_field_->clear();
  marks_.show(*recording_);
  if (!tags_field_->isModified()) showTags();
  note_table_->showAt(player_.time_s(), text.trimmed());
  curves_->setFocus();  // the keys of the place work again
}

void ReviewPage::writeTags() {
  if (!recording_ || !marks_.writeTags(tags_field_->text())) return;
  showTags();
  marks_.show(*recording_);
  curves_->setFocus();
}

void ReviewPage::showTags() { tags_field_->setText(marks_.tags().join(QStringLiteral(", "))); }

void ReviewPage::addCommands(PlaceCommands& commands) {
  const auto add = [&](const char* id, const char* text, const char* icon, const char* keys, auto run) {
    commands.add({id, kMenu, text, icon, keys}, [run](bool) { run(); });
  };
  add("review.open", QT_TRANSLATE_NOOP("Commands", "Open a recording…"), "", "Ctrl+O", [this] { list_->chooseFile(); });
  add("review.list", QT_TRANSLATE_NOOP("Commands", "List of sessions"), "log", "Ctrl+Shift+O", [this] { showList(); });
  add("review.compare", QT_TRANSLATE_NOOP("Commands", "Compare the two chosen sessions"), "", "", [this] {
    if (!showsList()) showList();
    list_->compareChosen();
  });
  add("review.go_to", QT_TRANSLATE_NOOP("Commands", "Go to a time"), "", "J", [this] { timeField()->setFocus(); });
  add("review.export", QT_TRANSLATE_NOOP("Commands", "Export, all or from A to B"), "save", "E", [this] {
    tabs_->setCurrentWidget(tabs_->exportPanel());
    tabs_->exportPanel()->writeButton()->setFocus();
  });
  add("review.tags", QT_TRANSLATE_NOOP("Commands", "Tags of the session"), "", "Shift+T",
      [this] { tags_field_->setFocus(); });
  add("review.play", QT_TRANSLATE_NOOP("Commands", "Play or pause"), "pause", "Space",
      [this] { player_.togglePlaying(); });
  add("review.next_sample", QT_TRANSLATE_NOOP("Commands", "Next sample"), "", "Right",
      [this] { player_.stepSamples(1); });
  add("review.previous_sample", QT_TRANSLATE_NOOP("Commands", "Previous sample"), "", "Left",
      [this] { player_.stepSamples(-1); });
  add("review.next_picture", QT_TRANSLATE_NOOP("Commands", "Next picture"), "", "Shift+Right",
      [this] { player_.stepPictures(1); });
  add("review.previous_picture", QT_TRANSLATE_NOOP("Commands", "Previous picture"), "", "Shift+Left",
      [this] { player_.stepPictures(-1); });
  add("review.mark_a", QT_TRANSLATE_NOOP("Commands", "Set A at the cursor"), "", "[", [this] { setMark(Mark::a); });
  add("review.mark_b", QT_TRANSLATE_NOOP("Commands", "Set B at the cursor"), "", "]", [this] { setMark(Mark::b); });
  add("review.clear_marks", QT_TRANSLATE_NOOP("Commands", "Take A and B away"), "", "\\", [this] {
    curves_->stack()->clearMarks();
    showMarks();
    tabs_->clearFigures();
  });
  curve_tools_->addCommands(commands, "review", kMenu, [this] {
    exports_->exportShown(*curves_, curve_tools_->saver().pathFor(QStringLiteral("csv")));
  });
  for (QToolButton* button : curve_tools_->makeButtons(this)) bar_->addButton(button);
  add("review.note", QT_TRANSLATE_NOOP("Commands", "Write a note at the cursor"), "", "N",
      [this] { note_field_->setFocus(); });
  add("review.bookmark", QT_TRANSLATE_NOOP("Commands", "Bookmark at the cursor"), "", "B",
      [this] { writeNote(recording::NoteKind::bookmark, tr("bookmark")); });
  add("review.whole", QT_TRANSLATE_NOOP("Commands", "Show the whole session"), "", "Home", [this] {
    if (recording_) curves_->show(0.0, recording_->info().duration_s);
  });
  add("review.gesture_card", QT_TRANSLATE_NOOP("Commands", "Make a gesture card of the chosen touch"), "save", "G",
      [this] { tabs_->makeCard(); });
  addExportCommands(commands);
  add("review.recover", QT_TRANSLATE_NOOP("Commands", "Recover a crashed recording"), "", "", [this] {
    if (showsList()) {
      list_->recoverPath();
    } else {
      recovery_->recover(shown_.path);
    }
  });
  add("review.cancel", QT_TRANSLATE_NOOP("Commands", "Cancel what is running"), "cross", kCancelWorkKeys, [this] {
    if (!work_->cancelNewest()) context_.tell(widgets::Severity::information, tr("Nothing is running here."));
  });
  const QStringList of_list = {QStringLiteral("review.open"), QStringLiteral("review.list"),
                               QStringLiteral("review.compare"), QStringLiteral("review.recover"),
                               QStringLiteral("review.cancel")};
  std::ranges::copy_if(commands.added(), std::back_inserter(recording_commands_),
                       [&](const QAction* each) { return !of_list.contains(each->objectName()); });
  offerCommands();
}

void ReviewPage::addExportCommands(PlaceCommands& commands) {
  struct Format {
    const char* id;
    const char* text;
    const char* keys;
    const char* ending;
  };
  for (const Format& each :
       {Format{"review.report_html", QT_TRANSLATE_NOOP("Commands", "Report as web page"), "Ctrl+P", "html"},
        Format{"review.report_pdf", QT_TRANSLATE_NOOP("Commands", "Report as PDF"), "Ctrl+Shift+P", "pdf"},
        Format{"review.export_csv", QT_TRANSLATE_NOOP("Commands", "Export as CSV"), "", "csv"},
        Format{"review.export_mat", QT_TRANSLATE_NOOP("Commands", "Export for MATLAB"), "", "mat"},
        Format{"review.export_mcap", QT_TRANSLATE_NOOP("Commands", "Export as MCAP"), "", "mcap"},
        Format{"review.export_mkv", QT_TRANSLATE_NOOP("Commands", "Export the camera's video"), "", "mkv"}}) {
    commands.add({each.id, kMenu, each.text, "save", each.keys},
                 [this, ending = QString::fromLatin1(each.ending)](bool) { exports_->exportAs(ending); });
  }
}

}  // namespace fyd::console
