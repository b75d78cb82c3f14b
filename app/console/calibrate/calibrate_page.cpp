#include "app/console/calibrate/calibrate_page.h"

#include <algorithm>

#include "app/console/calibrate/calibrate_records.h"
#include "app/console/shell/calibration_ages.h"
#include "app/console/shell/views.h"
#include "core/calibration/calibration_dependence.h"
#include "core/calibration/stiffness_map.h"
#include "core/station/profile/calibration_file.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/icon.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/theme.h"

namespace fyd::console {

using pipeline::SafetyState;

namespace {

/// Number of readings in the live figures: those of 1 s, or of one point when points are taken automatically.
int liveReadings(const CalibrationStep& step) {
  constexpr int kSecond_ms = 1000;
  return step.motion() != CalibrationStep::Motion::none ? step.readings() : kSecond_ms / step.interval_ms();
}

}  // namespace

CalibratePage::CalibratePage(const PageContext& context, QWidget* parent)
    : Page(parent), context_(context), profile_(context.session.currentProfile()) {
  steps_ = makeCalibrationSteps(profile_);
  build();
  parts_->setSteps(steps_);
  motion_ = new HeldMotion(context.session, buttons_->moveButton(), this);
  clock_.start();
  timer_.setInterval(kPoll_ms);
  connectButtons();
  connect(&timer_, &QTimer::timeout, this, &CalibratePage::poll);
  connect(parts_, &QListWidget::currentRowChanged, this, &CalibratePage::showStep);
  connect(entries_, &CalibrationEntryForm::entered, this, &CalibratePage::startPoint);
  connect(picture_, &widgets::PicturePick::placePicked, this, &CalibratePage::poll);
  connect(picture_, &widgets::PicturePick::rectanglePicked, this, &CalibratePage::poll);
  connect(&widgets::Look::instance(), &widgets::Look::changed, this, [this] {
    parts_->refresh(steps_, context_.tuning.profilePath(), profile_);
    refreshDrawing();
  });
  const SessionFeed* feed = &context_.feed;
  connect(feed, &SessionFeed::telemetry, this, [this](std::span<const pipeline::TelemetrySample> samples) {
    newest_ = samples.back();
    can_move_ = newest_.state == SafetyState::active || newest_.state == SafetyState::held;
    if (std::exchange(state_, newest_.state) != newest_.state) refreshButtons();
  });
  connect(feed, &SessionFeed::silent, this, [this](bool silent) {
    silent_ = silent;
    refreshButtons();
  });
  connect(feed, &SessionFeed::picture, this, [this](const station::CameraView& view) {
    if (isVisible() && step().picture() != CalibrationStep::Picture::none) picture_->setPicture(toImage(view.picture));
  });
  connect(feed, &SessionFeed::cameraMissing, picture_, &widgets::PicturePick::setEmptyText);
  parts_->refresh(steps_, context_.tuning.profilePath(), profile_);
  parts_->setCurrentRow(0);
}

void CalibratePage::connectButtons() {
  connect(buttons_->back(), &QPushButton::clicked, this, &CalibratePage::takeBack);
  connect(buttons_->take(), &QPushButton::clicked, this, &CalibratePage::startPoint);
  connect(buttons_->moveButton(), &widgets::HoldButton::held, this, &CalibratePage::startMotion);
  connect(buttons_->moveButton(), &widgets::HoldButton::letGo, motion_, &HeldMotion::end);
  connect(buttons_->report(), &QPushButton::clicked, this, &CalibratePage::writeReport);
  connect(buttons_->simulate(), &QPushButton::clicked, this, &CalibratePage::simulate);
  connect(buttons_->discard(), &QPushButton::clicked, this, &CalibratePage::discard);
  connect(buttons_->accept(), &QPushButton::clicked, this, &CalibratePage::accept);
  connect(motion_, &HeldMotion::ended, this, &CalibratePage::showMotionEnded);
}

void CalibratePage::addCommands(PlaceCommands& commands) {
  const auto add = [&](const char* id, const char* text, const char* keys, auto run) {
    commands.add({id, QT_TRANSLATE_NOOP("Commands", "Calibrate"), text, "", keys},
                 [this, run](bool) { (this->*run)(); });
  };
  add("calibrate.take", QT_TRANSLATE_NOOP("Commands", "Take point"), "Ctrl+Return", &CalibratePage::startPoint);
  add("calibrate.back", QT_TRANSLATE_NOOP("Commands", "Take the last point back"), "Ctrl+Backspace",
      &CalibratePage::takeBack);
  add("calibrate.discard", QT_TRANSLATE_NOOP("Commands", "Discard the points"), "Ctrl+Shift+Backspace",
      &CalibratePage::discard);
  add("calibrate.report", QT_TRANSLATE_NOOP("Commands", "Calibration report as PDF"), "Ctrl+Shift+P",
      &CalibratePage::writeReport);
  add("calibrate.accept", QT_TRANSLATE_NOOP("Commands", "Accept the calibration"), "Ctrl+Shift+Return",
      &CalibratePage::accept);
}

void CalibratePage::enter() {
  profile_ = context_.session.currentProfile();
  buttons_->simulate()->setVisible(context_.session.simulated());
  picture_->setPicture(toImage(context_.session.cameraView().picture));
  parts_->refresh(steps_, context_.tuning.profilePath(), profile_);
  refit();
  poll();
  timer_.start();
}

void CalibratePage::leave() {
  timer_.stop();
  motion_->end();
  endPoint({});
}

void CalibratePage::choose(const QString& id) {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (steps_[i]->id() == id) parts_->setCurrentRow(static_cast<int>(i));
  }
}

void CalibratePage::showStep(int step) {
  if (step < 0 || step >= static_cast<int>(steps_.size())) return;
  motion_->end();
  endPoint({});
  step_ = step;
  step_known_ = true;
  const CalibrationStep& now = this->step();
  entries_->setEntries(now.entries());
  timer_.setInterval(now.interval_ms());
  refreshDrawing();
  restartTrace();
  progress_->setValue(0);
  picture_->setVisible(now.picture() != CalibrationStep::Picture::none);
  picture_->setKind(now.picture() == CalibrationStep::Picture::rectangle ? widgets::PickKind::rectangle
                                                                         : widgets::PickKind::place);
  picture_->setPlace({});
  const sensing::FingerParameters& finger = profile_.step.sensing.finger;
  picture_->setRectangle(QRect(finger.roi_x_px, finger.roi_y_px, finger.roi_width_px, finger.roi_height_px));
  say({}, false);
  refit();
  offerNext();
  if (isVisible()) poll();
}

CalibrationScene CalibratePage::scene() const {
  return {.devices = devices_,
          .newest = newest_,
          .finger = finger_,
          .profile = profile_,
          .picture = picture_->picture(),
          .place_px = picture_->place(),
          .rectangle_px = picture_->rectangle(),
          .motion = motion_->status()};
}

void CalibratePage::poll() {
  devices_ = context_.session.devices();
  motion_->readStatus();
  finger_ = context_.session.cameraView().finger;
  const auto reading = step().read(scene());
  const bool traced = step().picture() == CalibrationStep::Picture::none;
  const double now_s = static_cast<double>(clock_.elapsed()) / 1000.0;
  if (!reading) {
    recent_.restart(liveReadings(step()));
    if (traced) trace_->add(now_s, {calibration::kUnknown});
    live_->setText(widgets::coreText(reading.error().message) + QLatin1Char('.'));
    if (taking_now_) endPoint(tr("Not taken: %1.").arg(widgets::coreText(reading.error().message)));
    return;
  }
  const auto wanted = step().signalsWanted(profile_);
  recent_.add(*reading);
  if (traced) trace_->add(now_s, {reading->begin(), reading->begin() + static_cast<std::ptrdiff_t>(traced_)});
  QStringList lines;
  const auto mean = recent_.mean(), spread = recent_.spread();
  for (std::size_t i = 0; i < std::min(wanted.size(), mean.size()); ++i) {
    lines << tr("%1 %2 ± %3")
                 .arg(wanted[i].name, widgets::quantityText(mean[i], wanted[i].decimals, wanted[i].unit),
                      widgets::numberText(spread[i], wanted[i].decimals));
  }
  if (!wanted.empty()) lines << (recent_.moving(wanted).isEmpty() ? tr("at rest") : tr("moving"));
  if (step().picture() == CalibrationStep::Picture::place) {
    lines << tr("x %1 px, y %2 px").arg(widgets::numberText(mean[0], 1), widgets::numberText(mean[1], 1));
  }
  if (step().picture() == CalibrationStep::Picture::rectangle) {
    const QRect& region = picture_->rectangle();
    lines << tr("%1 × %2 px at %3, %4").arg(region.width()).arg(region.height()).arg(region.x()).arg(region.y());
  }
  live_->setText(lines.join(wanted.size() > 1 ? QStringLiteral("\n") : QStringLiteral(" · ")));
  if (step().motion() != CalibrationStep::Motion::none) takeByItself(wanted);
  if (!taking_now_) return;
  taking_.add(*reading);
  progress_->setValue(static_cast<int>(100.0 * taking_.progress()));
  if (!taking_.full()) return;
  const QString moves = taking_.moving(wanted);
  if (moves.isEmpty()) {
    takePoint();
  } else {
    endPoint(tr("Not taken: %1. Wait until it rests and take the point again.").arg(moves));
  }
}

void CalibratePage::refreshDrawing() {
  constexpr QSize kDrawing(18 * widgets::kGrid, 9 * widgets::kGrid);
  QIcon drawing = widgets::icon(QStringLiteral("calibrate-%1").arg(QString::fromStdString(step().procedure())),
                                widgets::theme().muted);
  if (drawing.isNull()) drawing = widgets::icon(QStringLiteral("place-calibrate"), widgets::theme().muted);
  drawing_->setPixmap(drawing.pixmap(kDrawing, devicePixelRatioF()));
}

void CalibratePage::restartTrace() {
  recent_.restart(liveReadings(step()));
  const auto wanted = step().signalsWanted(profile_);
  QStringList names;
  for (const CalibrationSignal& signal : wanted) {
    const bool drawn =
        signal.unit == wanted.front().unit && names.size() < static_cast<int>(widgets::LiveTrace::kMostSignals);
    if (!drawn) break;
    names << signal.name;
  }
  traced_ = static_cast<std::size_t>(names.size());
  live_->setFont(
      widgets::textFont(wanted.size() > 1 ? widgets::TextSize::normal : widgets::TextSize::title, wanted.size() > 1));
  trace_->restart(names, wanted.empty() ? QString() : wanted.front().unit);
  trace_->setVisible(step().picture() == CalibrationStep::Picture::none);
}

void CalibratePage::refit() {
  const std::vector<CalibrationPoint>& points = this->points();
  fit_ = step().fit(points, profile_);
  if (step().trustsIndentation() && !points.empty()) {
    const auto records = station::loadCalibrationRecords(context_.tuning.profilePath().toStdString());
    if (!records || !calibration::clothProven(*records, bindParameters(profile_))) {
      calibration::sayIndentationUnproven(fit_.result);
    }
  }
  fit_panel_->setFit(fit_, points.size(), step().errorLimit(), profile_);
  instruction_->setText(step().instruction(points));
  missing_->setText(!fit_.missing.isEmpty() ? tr("Still missing: %1").arg(fit_.missing) : tr("Enough points."));
  if (points_.holdsSimulated(step_)) missing_->setText(missing_->text() + QLatin1Char(' ') + tr("Simulated points."));
  picture_->setMarks(step().marks(points));
  std::vector<double> levels;
  if (const int column = step().readingColumn(); column >= 0 && trace_->isVisibleTo(this)) {
    levels = columnOf(points, static_cast<std::size_t>(column));
  }
  trace_->setLevels(levels);
  refreshTable();
  refreshButtons();
}

void CalibratePage::refreshTable() {
  const std::vector<CalibrationPoint>& points = this->points();
  QStringList columns = step().columns();
  columns.replaceInStrings(QStringLiteral(", "), QStringLiteral("\n"));  // the unit below the name
  table_->clear();
  table_->setColumnCount(static_cast<int>(columns.size()));
  table_->setHorizontalHeaderLabels(columns);
  table_->shareWidth();
  table_->setRowCount(static_cast<int>(points.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const QStringList texts = step().row(points[static_cast<std::size_t>(row)]);
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
  const bool free = state_ == SafetyState::connected || state_ == SafetyState::ready || state_ == SafetyState::stopped;
  buttons_->allow({.moves = step().motion() != CalibrationStep::Motion::none,
                   .may_move = free && !silent_,
                   .renders = !free && !silent_,
                   .has_points = !points().empty(),
                   .taking = taking_now_,
                   .acceptable = fit_.result.verdict.accepted});
}

void CalibratePage::say(const QString& hint, bool warning) {
  hint_->setText(hint);
  hint_->setProperty("role", warning ? "warning" : "muted");
  widgets::restyle(*hint_);
}

}  // namespace fyd::console
