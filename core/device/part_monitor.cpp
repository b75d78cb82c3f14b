#include "core/device/part_monitor.h"

#include "core/device/in_use.h"

namespace fyd::device {

PartMonitor::PartMonitor(Part part, Message description, Duration longest_silence, Message waiting)
    : part_(part),
      description_(std::move(description)),
      longest_silence_(longest_silence),
      waiting_(std::move(waiting)) {}

bool PartMonitor::succeeded(Instant taken, const Message& complaint, bool measures) {
  rate_.count(taken);
  const std::lock_guard lock(mutex_);
  newest_ = taken;
  seen_ = true;
  measures_ = measures;
  const bool is_new = !complaint.empty() && problem_ != complaint;
  if (is_new) ++errors_;
  problem_ = complaint;
  return is_new;
}

bool PartMonitor::failed(const Message& problem) {
  const std::lock_guard lock(mutex_);
  ++errors_;
  measures_ = false;
  const bool is_new = problem_ != problem;
  problem_ = problem;
  return is_new;
}

void PartMonitor::describe(const Message& description) {
  const std::lock_guard lock(mutex_);
  description_ = description;
}

// The device's thread may be waiting for a time-out: the silence shows before that.
Message PartMonitor::problemAt(Instant now) const {
  if (!problem_.empty()) return problem_;
  if (!seen_) return waiting_;
  if (now - newest_ > longest_silence_) return say("silent; is it plugged in and switched on?");
  return {};
}

Message PartMonitor::problem(Instant now) const {
  const std::lock_guard lock(mutex_);
  return problemAt(now);
}

void PartMonitor::fillIn(DeviceReport& report, Instant now) const {
  const std::lock_guard lock(mutex_);
  report.problem = problemAt(now);
  report.ok = report.problem.empty();
  report.in_use = isInUse(report.problem);
  report.measures = !problem_.empty() && measures_;
  report.rate_hz = seen_ && now - newest_ < std::chrono::seconds(2) ? rate_.rate_hz() : 0.0;
  report.age_ms = seen_ ? toMilliseconds(now - newest_) : std::numeric_limits<double>::quiet_NaN();
  report.errors = errors_;
}

DeviceReport PartMonitor::report(Instant now) const {
  DeviceReport out{.part = part_};
  {
    const std::lock_guard lock(mutex_);
    out.description = description_;
  }
  fillIn(out, now);
  return out;
}

}  // namespace fyd::device
