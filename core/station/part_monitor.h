// How one device is doing, written by its thread, read by the window: rate, age, errors and the problem in words.
#pragma once

#include <atomic>
#include <limits>
#include <mutex>
#include <string>

#include "core/base/rate_meter.h"
#include "core/device/device_report.h"
#include "core/station/station.h"

namespace fyd::station {

/// The status' part of a device's report.
inline void fillIn(device::DeviceReport& report, const PartStatus& status) {
  report.ok = status.ok;
  report.problem = status.problem;
  report.rate_hz = status.rate_hz;
  report.age_ms = status.age_ms;
  report.errors = status.errors;
}

class PartMonitor {
 public:
  static constexpr Duration kSilence = std::chrono::milliseconds(500);

  /// @param longest_silence without news until it is shown as a problem
  PartMonitor(device::Part part, Message description, Duration longest_silence = Duration::max())
      : part_(part), description_(std::move(description)), longest_silence_(longest_silence) {}

  void succeeded(Instant taken) {
    rate_.count(taken);
    const std::lock_guard lock(mutex_);
    newest_ = taken;
    seen_ = true;
    problem_ = {};
  }

  /// @return true when this problem is new, so that it is logged once
  bool failed(const Message& problem) {
    const std::lock_guard lock(mutex_);
    ++errors_;
    const bool is_new = problem_ != problem;
    problem_ = problem;
    return is_new;
  }

  /// It answers, and complains. @return true when this complaint is new
  bool complained(const Message& problem, Instant taken) {
    rate_.count(taken);
    const std::lock_guard lock(mutex_);
    newest_ = taken;
    seen_ = true;
    const bool is_new = problem_ != problem;
    if (is_new) ++errors_;
    problem_ = problem;
    return is_new;
  }

  void describe(const Message& description) {
    const std::lock_guard lock(mutex_);
    description_ = description;
  }

  [[nodiscard]] PartStatus status(Instant now) const {
    const std::lock_guard lock(mutex_);
    PartStatus out{.part = part_, .description = description_, .problem = problem_, .errors = errors_};
    out.age_ms = seen_ ? toMilliseconds(now - newest_) : std::numeric_limits<double>::quiet_NaN();
    // Its thread may be waiting for a time-out: the silence shows before that.
    if (!seen_ && problem_.empty()) out.problem = say("nothing received yet");
    if (seen_ && problem_.empty() && now - newest_ > longest_silence_)
      out.problem = say("silent; is it plugged in and switched on?");
    out.ok = out.problem.empty();
    out.rate_hz = seen_ && now - newest_ < std::chrono::seconds(2) ? rate_.rate_hz() : 0.0;
    return out;
  }

 private:
  mutable std::mutex mutex_;
  device::Part part_;
  Message description_;
  const Duration longest_silence_;
  Message problem_;
  std::uint64_t errors_ = 0;
  bool seen_ = false;
  Instant newest_{};
  RateMeter rate_;
};

}  // namespace fyd::station
