// How one device is doing, written by its thread, read by the window: rate, age, errors and the problem in words.
#pragma once

#include <atomic>
#include <limits>
#include <mutex>
#include <string>

#include "core/station/rate_meter.h"
#include "core/station/station.h"

namespace fyd::station {

class PartMonitor {
 public:
  PartMonitor(std::string name, std::string description)
      : name_(std::move(name)), description_(std::move(description)) {}

  void succeeded(Instant taken) {
    rate_.count(taken);
    const std::lock_guard lock(mutex_);
    newest_ = taken;
    seen_ = true;
    problem_.clear();
  }

  /// @return true when this problem is new, so that it is logged once
  bool failed(const std::string& problem) {
    const std::lock_guard lock(mutex_);
    ++errors_;
    const bool is_new = problem_ != problem;
    problem_ = problem;
    return is_new;
  }

  /// It answers, and complains. @return true when this complaint is new
  bool complained(const std::string& problem, Instant taken) {
    rate_.count(taken);
    const std::lock_guard lock(mutex_);
    newest_ = taken;
    seen_ = true;
    const bool is_new = problem_ != problem;
    if (is_new) ++errors_;
    problem_ = problem;
    return is_new;
  }

  void describe(const std::string& description) {
    const std::lock_guard lock(mutex_);
    description_ = description;
  }

  [[nodiscard]] PartStatus status(Instant now) const {
    const std::lock_guard lock(mutex_);
    PartStatus out{.name = name_, .description = description_, .problem = problem_, .errors = errors_};
    out.ok = seen_ && problem_.empty();
    if (!seen_ && problem_.empty()) out.problem = "nothing received yet";
    out.age_ms = seen_ ? toMilliseconds(now - newest_) : std::numeric_limits<double>::quiet_NaN();
    out.rate_hz = seen_ && now - newest_ < std::chrono::seconds(2) ? rate_.rate_hz() : 0.0;
    return out;
  }

 private:
  mutable std::mutex mutex_;
  std::string name_;
  std::string description_;
  std::string problem_;
  std::uint64_t errors_ = 0;
  bool seen_ = false;
  Instant newest_{};
  RateMeter rate_;
};

}  // namespace fyd::station
