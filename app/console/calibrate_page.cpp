#include "app/console/calibrate_page.h"

#include <algorithm>

#include "app/console/views.h"
#include "core/calibration/calibration_dependence.h"
#include "core/calibration/stiffness_map.h"
#include "core/station/calibration_file.h"
#include "widgets/core_text.h"
#include "widgets/icon.h"
#include "widgets/number_text.h"
#include "widgets/theme.h"

namespace fyd::console {

using pipeline::SafetyState;

namespace {

/// Readings behind the live figures: 1 s, or as many as a point that is taken by itself.
int liveReadings(const CalibrationStep& step) {
  constexpr int kSecond_ms = 1000;
  return step.motion() != CalibrationStep::Motion::none ? step.readings() : kSecond_ms / step.interval_ms();
}

QString signOf(PartState::Kind kind) {
  switch (kind) {
    case PartState::Kind::fine: return QStringLiteral("●");
    case PartState::Kind::ageing: return QStringLiteral("◐");
    case PartState::Kind::old: return QStringLiteral("!");
    case PartState::Kind::outdated: return QStringLiteral("↻");
    case PartState::Kind::changed: return QStringLiteral("≠");
    case PartState::Kind::never: break;
  }
  return QStringLiteral("○");
}

}  // namespace

CalibratePage::CalibratePage(const PageContext& context, QWidget* parent)
    : Page(parent), context_(context), profile_(context.session.currentProfile()) {
  steps_ = makeCalibrationSteps(profile_);
  build();
  for (std::size_t i = 0; i < steps_.size(); ++i) parts_->addItem(new QListWidgetItem);
  clock_.start();
  timer_.setInterval(kPoll_ms);
  hold_timer_.setInterval(kPoll_ms);
  connect(&hold_timer_, &QTimer::timeout, this, &CalibratePage::holdOn);
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
  refreshParts();
  parts_->setCurrentRow(0);
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
  simulate_->setVisible(context_.session.simulated());
  picture_->setPicture(toImage(context_.session.cameraView().picture));
  refreshParts();
  refit();
  poll();
  timer_.start();
}

void CalibratePage::leave() {
  timer_.stop();
  endMotion();
  endPoint({});
}

void CalibratePage::choose(const QString& id) {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (steps_[i]->id() == id) parts_->setCurrentRow(static_cast<int>(i));
  }
}

void CalibratePage::showStep(int step) {
  if (step < 0 || step >= static_cast<int>(steps_.size())) return;
  endMotion();
  endPoint({});
  step_ = step;
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
          .motion = motion_};
}

void CalibratePage::poll() {
  devices_ = context_.session.devices();
  motion_ = context_.session.deviceTestStatus();
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
  const std::vector<CalibrationPoint>& points = points_[step_];
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
  if (!points.empty() && simulated_[step_])
    missing_->setText(missing_->text() + QLatin1Char(' ') + tr("Simulated points."));
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
  const std::vector<CalibrationPoint>& points = points_[step_];
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
  table_->setMinimumWidth(table_->wholeWidth());  // the fit beside it gives way
  table_->scrollToBottom();
}

void CalibratePage::refreshParts() {
  const auto records = station::loadCalibrationRecords(context_.tuning.profilePath().toStdString());
  const std::string today = nowUtc();
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    PartState state{PartState::Kind::old, {}};
    if (records) {
      state = partStateOf(*records, steps_[i]->procedure(), steps_[i]->sensor(), profile_, today);
    } else {
      state.words = widgets::coreText(records.error().message);
    }
    QListWidgetItem* item = parts_->item(static_cast<int>(i));
    item->setText(signOf(state.kind) + QLatin1Char(' ') + steps_[i]->name() + QLatin1Char('\n') + state.words);
    item->setToolTip(state.words);
    item->setForeground(isDoubtful(state.kind) ? widgets::theme().warning : widgets::theme().text);
  }
}

void CalibratePage::refreshButtons() {
  const bool any = !points_[step_].empty();
  const bool moves = step().motion() != CalibrationStep::Motion::none;
  const bool free = state_ == SafetyState::connected || state_ == SafetyState::ready || state_ == SafetyState::stopped;
  take_->setVisible(!moves);
  move_->setVisible(moves);
  move_->setEnabled(free && !silent_);
  why_still_->setVisible(moves && !free && !silent_);
  report_->setEnabled(!taking_now_);
  take_->setEnabled(!taking_now_);
  simulate_->setEnabled(!taking_now_);
  back_->setEnabled(any && !taking_now_);
  discard_->setEnabled(any || taking_now_);
  accept_->setEnabled(any && !taking_now_ && fit_.result.verdict.accepted);
}

void CalibratePage::say(const QString& hint, bool warning) {
  hint_->setText(hint);
  hint_->setProperty("role", warning ? "warning" : "muted");
  widgets::restyle(*hint_);
}

}  // namespace fyd::console
