// How one device is doing, written by its thread, read by the window: rate, age, errors and the problem in words.
#pragma once

#include <mutex>

#include "core/base/rate_meter.h"
#include "core/base/time.h"
#include "core/device/device_report.h"

namespace fyd::device {

class PartMonitor {
 public:
  /// @param longest_silence without news until it is shown as a problem
  /// @param waiting the problem shown before the first answer
  PartMonitor(Part part, Message description, Duration longest_silence = Duration::max(),
              Message waiting = say("nothing received yet"));

  /// It answered. @param complaint what is wrong all the same; empty: nothing
  /// @param measures although it complains, what it measures is good
  /// @return true when this complaint is new, so that it is logged once
  bool succeeded(Instant taken, const Message& complaint = {}, bool measures = false);
  /// It did not answer. @return true when this problem is new
  bool failed(const Message& problem);
  void describe(const Message& description);

  [[nodiscard]] Message problem(Instant now) const;
  /// Part and description, and what `fillIn` writes.
  [[nodiscard]] DeviceReport report(Instant now) const;
  /// Writes ok, problem, in_use, measures, rate_hz, age_ms and errors.
  void fillIn(DeviceReport& report, Instant now) const;

 private:
  [[nodiscard]] Message problemAt(Instant now) const;  // with mutex_ held

  mutable std::mutex mutex_;
  const Part part_;
  Message description_;
  const Duration longest_silence_;
  const Message waiting_;
  Message problem_;
  std::uint64_t errors_ = 0;
  bool seen_ = false;
  bool measures_ = false;
  Instant newest_{};
  RateMeter rate_;
};

}  // namespace fyd::device
