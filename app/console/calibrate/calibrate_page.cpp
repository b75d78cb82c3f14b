#include "app/console/calibrate/calibrate_page.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "app/console/shell/views.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/icon.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::console {

using widgets::kGrid;
using widgets::TextSize;

namespace {

QFrame* panel(QWidget* parent, QVBoxLayout*& layout) {
  auto* out = new QFrame(parent);
  out->setProperty("surface", "panel");
  layout = new QVBoxLayout(out);
  layout->setContentsMargins(2 * kGrid, kGrid, 2 * kGrid, kGrid);
  layout->setSpacing(kGrid);
  return out;
}

/// The session's newest picture is one of before.
bool cameraIsMissing(const Session& session) {
  return std::ranges::any_of(session.status().parts, [](const device::DeviceReport& part) {
    return part.part == device::Part::camera && !part.ok;
  });
}

}  // namespace

CalibratePage::CalibratePage(const PageContext& context, QWidget* parent) : Page(parent), context_(context) {
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid);
  row->addWidget(buildLeft());
  row->addWidget(buildMiddle(), 2);
  fit_panel_ = new CalibrationFitPanel(this);
  row->addWidget(fit_panel_, 3);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  layout->addLayout(row, 1);
  buttons_ = new CalibrationButtons(this);
  layout->addWidget(buttons_);
  run_ = new CalibrationRun(context_, buttons_->moveButton(), this);
  parts_->setSteps(run_->steps());
  clock_.start();
  timer_.setInterval(kPoll_ms);
  connectRun();
  connectButtons();
  connect(&timer_, &QTimer::timeout, this, &CalibratePage::poll);
  connect(parts_, &QListWidget::currentRowChanged, this, &CalibratePage::showStep);
  connect(entries_, &CalibrationEntryForm::entered, this, &CalibratePage::startPoint);
  connect(picture_, &widgets::PicturePick::placePicked, this, &CalibratePage::poll);
  connect(picture_, &widgets::PicturePick::rectanglePicked, this, &CalibratePage::poll);
  connect(&widgets::Look::instance(), &widgets::Look::changed, this, [this] {
    refreshParts();
    refreshDrawing();
  });
  const SessionFeed* feed = &context_.feed;
  connect(feed, &SessionFeed::picture, this, [this](const station::CameraView& view) {
    if (isVisible() && run_->step().picture() != CalibrationStep::Picture::none)
      picture_->setPicture(toImage(view.picture));
  });
  connect(feed, &SessionFeed::notice, this, [this](const station::Notice& notice) {
    if (!notice.of_step || notice.event.kind != pipeline::EventKind::tare_done) return;
    run_->forgetTared();
    if (!isVisible()) return;  // enter() takes the values in force
    run_->takeTare();
    refreshParts();
  });
  connect(feed, &SessionFeed::cameraMissing, picture_, &widgets::PicturePick::showMissing);
  connect(feed, &SessionFeed::restarted, picture_,
          [this] { picture_->showMissing(widgets::CameraImage::noneYet()); });  // the picture is of the former camera
  connect(&context_.connection, &ConnectionChange::arrived, this, &CalibratePage::changeDevices);
  refreshParts();
  parts_->setCurrentRow(0);
}

QWidget* CalibratePage::buildLeft() {
  QVBoxLayout* layout = nullptr;
  QFrame* out = panel(this, layout);
  out->setFixedWidth(32 * kGrid);
  auto* title = new QLabel(tr("Can I trust the sensors?"), out);
  title->setFont(widgets::textFont(TextSize::normal, true));
  parts_ = new CalibrationPartList(out);
  auto* now = new QLabel(tr("What to do now"), out);
  now->setFont(widgets::textFont(TextSize::small));
  now->setProperty("role", "muted");
  drawing_ = new QLabel(out);
  drawing_->setObjectName(QStringLiteral("calibration_drawing"));
  instruction_ = new QLabel(out);
  instruction_->setObjectName(QStringLiteral("calibration_instruction"));
  instruction_->setFont(widgets::textFont(TextSize::normal, true));
  instruction_->setWordWrap(true);
  entries_ = new CalibrationEntryForm(out);
  layout->addWidget(title);
  layout->addWidget(parts_, 1);
  layout->addWidget(now);
  layout->addWidget(drawing_);
  layout->addWidget(instruction_);
  layout->addWidget(entries_);
  return out;
}

QWidget* CalibratePage::buildMiddle() {
  QVBoxLayout* layout = nullptr;
  QFrame* out = panel(this, layout);
  picture_ = new widgets::PicturePick(out);
  live_ = new QLabel(out);
  live_->setObjectName(QStringLiteral("calibration_live"));
  live_->setFont(widgets::textFont(TextSize::title));
  live_->setWordWrap(true);
  progress_ = new QProgressBar(out);
  progress_->setTextVisible(false);
  progress_->setRange(0, 100);
  progress_->setFixedHeight(kGrid / 2);
  progress_->setAccessibleName(tr("Averaging"));
  hint_ = new QLabel(out);
  hint_->setObjectName(QStringLiteral("calibration_hint"));
  hint_->setWordWrap(true);
  trace_ = new widgets::LiveTrace(out);
  table_ = new widgets::HeadingTable(out);
  table_->setObjectName(QStringLiteral("calibration_points"));
  table_->setAccessibleName(tr("Points taken"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->horizontalHeader()->setFont(widgets::textFont(TextSize::small));
  missing_ = new QLabel(out);
  missing_->setObjectName(QStringLiteral("calibration_missing"));
  missing_->setWordWrap(true);
  missing_->setProperty("role", "muted");
  layout->addWidget(picture_, 3);
  layout->addWidget(live_);
  layout->addWidget(progress_);
  layout->addWidget(hint_);
  layout->addWidget(trace_, 3);  // high enough for the words at its axis
  layout->addWidget(table_, 2);
  layout->addWidget(missing_);
  return out;
}

void CalibratePage::connectRun() {
  connect(run_, &CalibrationRun::said, this, &CalibratePage::say);
  connect(run_, &CalibrationRun::fitted, this, &CalibratePage::refreshFit);
  connect(run_, &CalibrationRun::allowedChanged, this, &CalibratePage::refreshButtons);
  connect(run_, &CalibrationRun::pointTaken, this, &CalibratePage::showPointTaken);
  connect(run_, &CalibrationRun::motionEnded, this, &CalibratePage::offerNext);
  connect(run_, &CalibrationRun::fingerLifted, this, &CalibratePage::startPoint);
  connect(run_, &CalibrationRun::accepted, this, &CalibratePage::refreshParts);
  connect(run_, &CalibrationRun::nameMissing, fit_panel_, &CalibrationFitPanel::askWho);
}

void CalibratePage::connectButtons() {
  connect(buttons_->take(), &QPushButton::clicked, this, &CalibratePage::startPoint);
  connect(buttons_->back(), &QPushButton::clicked, run_, &CalibrationRun::takeBack);
  connect(buttons_->moveButton(), &widgets::HoldButton::held, this, [this] { run_->startMotion(entries_->read()); });
  connect(buttons_->report(), &QPushButton::clicked, run_, &CalibrationRun::writeReport);
  connect(buttons_->simulate(), &QPushButton::clicked, this, [this] {
    run_->simulate();
    offerNext();
  });
  connect(buttons_->discard(), &QPushButton::clicked, this, [this] {
    run_->discard();
    offerNext();
  });
  connect(buttons_->accept(), &QPushButton::clicked, this, [this] { run_->accept(fit_panel_->words()); });
}

void CalibratePage::addCommands(PlaceCommands& commands) {
  const auto add = [&](const char* id, const char* text, const char* keys, auto run) {
    commands.add({id, QT_TRANSLATE_NOOP("Commands", "Calibrate"), text, "", keys}, [run](bool) { run(); });
  };
  add("calibrate.take", QT_TRANSLATE_NOOP("Commands", "Take point"), "Ctrl+Return", [this] { startPoint(); });
  add("calibrate.back", QT_TRANSLATE_NOOP("Commands", "Take the last point back"), "Ctrl+Backspace",
      [this] { run_->takeBack(); });
  add("calibrate.discard", QT_TRANSLATE_NOOP("Commands", "Discard the points"), "Ctrl+Shift+Backspace", [this] {
    run_->discard();
    offerNext();
  });
  add("calibrate.report", QT_TRANSLATE_NOOP("Commands", "Calibration report as PDF"), "Ctrl+Shift+P",
      [this] { run_->writeReport(); });
  add("calibrate.accept", QT_TRANSLATE_NOOP("Commands", "Accept the calibration"), "Ctrl+Shift+Return",
      [this] { run_->accept(fit_panel_->words()); });
}

void CalibratePage::enter() {
  buttons_->simulate()->setVisible(context_.session.simulated());
  picture_->setPicture(cameraIsMissing(context_.session) ? QImage() : toImage(context_.session.cameraView().picture));
  run_->takeProfile();
  refreshParts();
  poll();
  timer_.start();
}

void CalibratePage::changeDevices() {
  run_->changeDevices();
  buttons_->simulate()->setVisible(context_.session.simulated());
  refreshParts();
  showStep(parts_->currentRow());
}

QString CalibratePage::unfinished() const {
  const QStringList parts = run_->unaccepted();
  return parts.isEmpty() ? QString() : tr("calibration points not accepted: %1").arg(parts.join(QStringLiteral(", ")));
}

void CalibratePage::leave() {
  timer_.stop();
  run_->end();
}

void CalibratePage::choose(const QString& id) {
  const CalibrationSteps& steps = run_->steps();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i]->id() == id) parts_->setCurrentRow(static_cast<int>(i));
  }
}

void CalibratePage::showStep(int index) {
  if (index < 0 || index >= static_cast<int>(run_->steps().size())) return;
  run_->choose(index);
  const CalibrationStep& step = run_->step();
  entries_->setEntries(step.entries());
  QWidget* before = parts_;  // fields made later would come last
  for (std::size_t i = 0; i < step.entries().size(); ++i) {
    for (QWidget* each : {static_cast<QWidget*>(entries_->field(i)), static_cast<QWidget*>(entries_->unit(i))}) {
      setTabOrder(before, each);
      before = each;
    }
  }
  timer_.setInterval(step.interval_ms());
  refreshDrawing();
  restartTrace();
  picture_->setVisible(step.picture() != CalibrationStep::Picture::none);
  picture_->setKind(step.picture() == CalibrationStep::Picture::rectangle ? widgets::PickKind::rectangle
                                                                          : widgets::PickKind::place);
  picture_->setPlace({});
  const sensing::FingerParameters& finger = run_->profile().step.sensing.finger;
  picture_->setRectangle(QRect(finger.roi_x_px, finger.roi_y_px, finger.roi_width_px, finger.roi_height_px));
  refreshFit();
  offerNext();
  if (isVisible()) poll();
}

CalibrationRun::Picks CalibratePage::picks() const {
  return {.picture = picture_->picture(), .place_px = picture_->place(), .rectangle_px = picture_->rectangle()};
}

void CalibratePage::startPoint() { run_->startPoint(picks(), entries_->read()); }

void CalibratePage::poll() {
  const CalibrationRun::Picks now = picks();
  const auto reading = run_->read(now);
  showReading(reading);
  if (reading) run_->advance(now, *reading);
  progress_->setValue(static_cast<int>(100.0 * run_->progress()));
}

void CalibratePage::showReading(const Result<std::vector<double>>& reading) {
  const CalibrationStep& step = run_->step();
  const bool traced = step.picture() == CalibrationStep::Picture::none;
  const double now_s = static_cast<double>(clock_.elapsed()) / 1000.0;
  if (!reading) {
    if (traced) trace_->add(now_s, {calibration::kUnknown});
    live_->setText(widgets::coreText(reading.error().message) + QLatin1Char('.'));
    return;
  }
  if (traced) trace_->add(now_s, {reading->begin(), reading->begin() + static_cast<std::ptrdiff_t>(traced_)});
  const auto wanted = step.signalsWanted(run_->profile());
  const auto mean = run_->recent().mean(), spread = run_->recent().spread();
  QStringList lines;
  for (std::size_t i = 0; i < std::min(wanted.size(), mean.size()); ++i) {
    lines << tr("%1: %2 ± %3")
                 .arg(wanted[i].name, widgets::quantityText(mean[i], wanted[i].decimals, wanted[i].unit),
                      widgets::numberText(spread[i], wanted[i].decimals));
  }
  if (!wanted.empty()) lines << (run_->recent().moving(wanted).isEmpty() ? tr("at rest") : tr("moving"));
  if (step.picture() == CalibrationStep::Picture::place) {
    lines << tr("x %1 px, y %2 px").arg(widgets::numberText(mean[0], 1), widgets::numberText(mean[1], 1));
  }
  if (step.picture() == CalibrationStep::Picture::rectangle) {
    const QRect& region = picture_->rectangle();
    lines << tr("%1 × %2 px at %3, %4").arg(region.width()).arg(region.height()).arg(region.x()).arg(region.y());
  }
  live_->setText(lines.join(wanted.size() > 1 ? QStringLiteral("\n") : QStringLiteral(" · ")));
}

void CalibratePage::showPointTaken(bool by_hand) {
  trace_->mark();
  if (!by_hand) return;
  entries_->clear();
  picture_->setPlace({});
  if (!run_->step().entries().empty()) entries_->field(0)->setFocus();
}

/// With motion, the first field is what the next motion goes to.
void CalibratePage::offerNext() {
  const CalibrationStep& step = run_->step();
  const double next = step.offer(run_->points());
  if (step.entries().empty() || step.motion() == CalibrationStep::Motion::none) return;
  if (std::isfinite(next)) entries_->field(0)->setText(widgets::plainNumber(next));
}

void CalibratePage::refreshDrawing() {
  constexpr QSize kDrawing(18 * kGrid, 9 * kGrid);
  const QString part = QString::fromStdString(run_->step().procedure());
  QIcon drawing = widgets::icon(QStringLiteral("calibrate-") + part, widgets::theme().muted);
  if (drawing.isNull()) drawing = widgets::icon(QStringLiteral("place-calibrate"), widgets::theme().muted);
  drawing_->setPixmap(drawing.pixmap(kDrawing, devicePixelRatioF()));
}

void CalibratePage::refreshParts() {
  parts_->refresh(run_->steps(), context_.tuning.profilePath(), run_->profile());
  fit_panel_->offerName(lastWhoCalibrated(context_));
}

void CalibratePage::restartTrace() {
  const auto wanted = run_->step().signalsWanted(run_->profile());
  QStringList names;
  for (const CalibrationSignal& signal : wanted) {
    const bool drawn =
        signal.unit == wanted.front().unit && names.size() < static_cast<int>(widgets::LiveTrace::kMostSignals);
    if (!drawn) break;
    names << signal.name;
  }
  traced_ = static_cast<std::size_t>(names.size());
  live_->setFont(widgets::textFont(wanted.size() > 1 ? TextSize::normal : TextSize::title, wanted.size() > 1));
  trace_->restart(names, wanted.empty() ? QString() : wanted.front().unit);
  trace_->setVisible(run_->step().picture() == CalibrationStep::Picture::none);
}

void CalibratePage::refreshFit() {
  const CalibrationStep& step = run_->step();
  const std::vector<CalibrationPoint>& points = this->points();
  fit_panel_->setFit(run_->fit(), points.size(), step.errorLimit(), run_->profile());
  instruction_->setText(step.instruction(points));
  const QString& missing = run_->fit().missing;
  missing_->setText(!missing.isEmpty() ? tr("Still missing: %1").arg(missing) : tr("Enough points."));
  if (run_->holdsSimulated()) missing_->setText(missing_->text() + QLatin1Char(' ') + tr("Simulated points."));
  picture_->setMarks(step.marks(points));
  std::vector<double> levels;
  if (const int column = step.readingColumn(); column >= 0 && trace_->isVisibleTo(this)) {
    levels = columnOf(points, static_cast<std::size_t>(column));
  }
  trace_->setLevels(levels);
  refreshTable();
  refreshButtons();
}

void CalibratePage::refreshTable() {
  const std::vector<CalibrationPoint>& points = this->points();
  QStringList columns = run_->step().columns();
  columns.replaceInStrings(QStringLiteral(", "), QStringLiteral("\n"));  // the unit below the name
  table_->clear();
  table_->setColumnCount(static_cast<int>(columns.size()));
  table_->setHorizontalHeaderLabels(columns);
  table_->shareWidth();
  table_->setRowCount(static_cast<int>(points.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const QStringList texts = run_->step().row(points[static_cast<std::size_t>(row)]);
    for (int column = 0; column < texts.size(); ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, column, item);
    }
  }
  table_->setMinimumWidth(table_->wholeWidth());  // the fit beside it gets narrower
  table_->scrollToBottom();
}

void CalibratePage::refreshButtons() {
  // A button that may not be pressed now loses the focus to whatever comes next in the window; the list is harmless.
  QWidget* pressed = QApplication::focusWidget();
  if (!buttons_->isAncestorOf(pressed)) pressed = nullptr;
  buttons_->allow({.moves = run_->step().motion() != CalibrationStep::Motion::none,
                   .may_move = run_->mayMove(),
                   .why_still = run_->whyStill(),
                   .has_points = !points().empty(),
                   .taking = run_->taking(),
                   .acceptable = run_->fit().result.verdict.accepted});
  if (pressed != nullptr && !(pressed->isEnabled() && pressed->isVisible())) parts_->setFocus(Qt::OtherFocusReason);
}

void CalibratePage::say(const QString& hint, bool warning) {
  hint_->setText(hint);
  hint_->setProperty("role", warning ? "warning" : "muted");
  widgets::restyle(*hint_);
}

}  // namespace fyd::console
