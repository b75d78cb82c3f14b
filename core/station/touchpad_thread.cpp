#include "core/station/touchpad_thread.h"

#include <spdlog/spdlog.h>

#include "core/station/real_time.h"

namespace fyd::station {
namespace {

constexpr Duration kTouchpadSilence = std::chrono::milliseconds(500);
constexpr Duration kFirstRetry = std::chrono::milliseconds(20);
constexpr Duration kLongestRetry = std::chrono::milliseconds(500);
constexpr Duration kTouchpadLateness = std::chrono::milliseconds(2);  // of this thread, where the clock waits for it
constexpr Duration kReportPeriod = std::chrono::milliseconds(16);     // as often as a distance sensor measures

}  // namespace

control::MotorCommand guardedCommand(const StampedMotorCommand& stamped, Instant now) {
  control::MotorCommand command = stamped.command;
  if (now - stamped.given > kCommandTimeout) command.vibration_duty_percent = {};
  return command;
}

TouchpadThread::TouchpadThread(std::unique_ptr<device::Touchpad> touchpad, const device::DeviceParameters& parameters,
                               bool clock_waits)
    : touchpad_(std::move(touchpad)),
      plausibility_(parameters),
      frozen_(parameters),
      monitor_(device::Part::touchpad, touchpad_->description(), kTouchpadSilence),
      clock_waits_(clock_waits) {}

TouchpadThread::~TouchpadThread() { shutDown(); }

void TouchpadThread::start() {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void TouchpadThread::shutDown() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

// Duties that waited while the device did not answer are discarded.
void TouchpadThread::takeDuties() {
  std::array<device::VibrationDuty, 64> batch{};
  while (const std::size_t taken = duties.pop(batch.data(), batch.size())) {
    if (answering_) touchpad_->queueVibration({batch.data(), taken});
  }
}

void TouchpadThread::report(Instant now, bool released) {
  if (!answering_) monitor_.describe(touchpad_->description());
  answering_ = true;
  Message complaint = touchpad_->complaint();
  if (complaint.empty()) complaint = plausibility_.complaint();
  if (complaint.empty()) complaint = frozen_.complaint();
  const bool measures = complaint.empty();
  if (complaint.empty() && released) complaint = touchpad_->whySwitchedOff();
  if (complaint.empty() && released) complaint = plausibility_.whyWithheld();
  if (monitor_.succeeded(now, complaint, measures)) spdlog::warn("Touchpad: {}", complaint.text());
}

void TouchpadThread::publishReports(Instant now) {
  if (now < reports_due_) return;
  reports_due_ = now + kReportPeriod;
  auto reports = touchpad_->reports();
  const std::lock_guard lock(reports_mutex_);
  reports_ = std::move(reports);
}

std::vector<device::DeviceReport> TouchpadThread::reports(Instant now) const {
  std::vector<device::DeviceReport> out;
  {
    const std::lock_guard lock(reports_mutex_);
    out = reports_;
  }
  if (out.size() == 1) monitor_.fillIn(out.front(), now);
  return out;
}

void TouchpadThread::run(const std::stop_token& stop) {
  askForRealTime(Urgency::device);
  ClockHold hold(clock_waits_);
  Duration retry = kFirstRetry;
  Instant due = Clock::now();
  control::MotorCommand last;
  while (!stop.stop_requested()) {
    const Instant now = Clock::now();
    const StampedMotorCommand& stamped = command.read();
    last = guardedCommand(stamped, now);
    takeDuties();
    const auto exchanged = touchpad_->exchange(last, now);
    if (exchanged) {
      control::MotorCommand followed = last;
      followed.active = last.active && touchpad_->driven();
      readings.write(plausibility_.check(frozen_.check(*exchanged), followed, now));
      report(now, stamped.released);
      retry = kFirstRetry;
      due = std::max(due + touchpad_->period(), Clock::now());
    } else {
      answering_ = false;
      if (monitor_.failed(exchanged.error().message)) spdlog::warn("Touchpad: {}", exchanged.error().text());
      due = Clock::now() + retry;
      retry = std::min(2 * retry, kLongestRetry);
    }
    publishReports(now);
    hold.until(due + kTouchpadLateness);
    Clock::sleepUntil(due);
  }
  takeDuties();
  last.active = false;
  last.vibration_duty_percent = {};
  for (int i = 0; i < device::kFarewells && !touchpad_->exchange(last, Clock::now()); ++i) continue;
}

}  // namespace fyd::station
