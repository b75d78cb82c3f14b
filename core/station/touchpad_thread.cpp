#include "core/station/touchpad_thread.h"

#include <spdlog/spdlog.h>

#include "core/station/real_time.h"

namespace fyd::station {
namespace {

constexpr Duration kFirstRetry = std::chrono::milliseconds(20);
constexpr Duration kLongestRetry = std::chrono::milliseconds(500);

}  // namespace

control::MotorCommand guardedCommand(const StampedMotorCommand& stamped, Instant now) {
  control::MotorCommand command = stamped.command;
  if (now - stamped.given > kCommandTimeout) command.vibration_duty_percent = {};
  return command;
}

TouchpadThread::TouchpadThread(std::unique_ptr<device::Touchpad> touchpad)
    : touchpad_(std::move(touchpad)), monitor_("Touchpad", touchpad_->description()) {}

TouchpadThread::~TouchpadThread() { shutDown(); }

void TouchpadThread::start() {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void TouchpadThread::shutDown() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

void TouchpadThread::run(const std::stop_token& stop) {
  askForRealTime(Urgency::device);
  Duration retry = kFirstRetry;
  Instant due = Clock::now();
  control::MotorCommand last;
  while (!stop.stop_requested()) {
    const Instant now = Clock::now();
    last = guardedCommand(command.read(), now);
    const auto exchanged = touchpad_->exchange(last, now);
    if (exchanged) {
      readings.write(*exchanged);
      monitor_.succeeded(now);
      retry = kFirstRetry;
      due = std::max(due + touchpad_->period(), Clock::now());
    } else {
      if (monitor_.failed(exchanged.error().message)) spdlog::warn("Touchpad: {}", exchanged.error().message);
      due = Clock::now() + retry;
      retry = std::min(2 * retry, kLongestRetry);
    }
    std::this_thread::sleep_until(due);
  }
  last.active = false;
  last.vibration_duty_percent = {};
  (void)touchpad_->exchange(last, Clock::now());
}

}  // namespace fyd::station
