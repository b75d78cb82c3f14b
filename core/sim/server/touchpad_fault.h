// Faults that the simulated touchpad produces on demand, each at its time.
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <mutex>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/time.h"

namespace fyd::sim {

enum class TouchpadFault : std::uint8_t {
  late_reply,     ///< answers and pictures come 250 ms late; without a duration one of them
  silence,        ///< no answers, no pictures
  stuck_sensor,   ///< IR sensor 1 repeats its last code
  brown_out,      ///< the supply breaks down (0.5 s without a duration): silence, then a restart with the motors off
  encoder_jump,   ///< encoder 1 reads 512 counts too many
  camera_freeze,  ///< the camera's stream goes on with the same picture
  garbage,        ///< random bytes in place of answers and pictures
  frozen_values,  ///< all sensors and encoders repeat their last values, their counts go on
  bridge_end,     ///< the load cell's bridge reads the end of its converter's range
  hot_reading,    ///< motor 1 reads 3276.7 °C
  disobedience,   ///< writes are answered without effect, and bit 9 of the status word says so
  camera_flat,    ///< pictures of one grey
  camera_damage,  ///< eight bytes of each picture are wrong
  camera_cut,     ///< only a third of each picture
};
inline constexpr std::array<std::string_view, 14> kTouchpadFaultNames = {
    "late-reply",    "silence",    "stuck-sensor", "brown-out",    "encoder-jump", "camera-freeze", "garbage",
    "frozen-values", "bridge-end", "hot-reading",  "disobedience", "camera-flat",  "camera-damage", "camera-cut"};

inline constexpr Duration kLateBy = std::chrono::milliseconds(250);

struct TimedFault {
  TouchpadFault fault{};
  double at_s = 0.0;
  double for_s = std::numeric_limits<double>::infinity();
};

/// Reads "NAME@T" or "NAME@T+D", seconds. A late reply without D lasts for one answer, a brown-out for 0.5 s, any other
/// fault to the end.
[[nodiscard]] Result<TimedFault> parseTimedFault(std::string_view text);

/// Copies share one plan: a fault added to one of them is in all. Thread-safe.
class FaultPlan {
 public:
  FaultPlan() : FaultPlan({}, {}) {}
  FaultPlan(std::vector<TimedFault> faults, Instant start) : shared_(std::make_shared<Shared>()), start_(start) {
    shared_->faults = std::move(faults);
  }

  /// Begins a fault that was not planned.
  void add(TouchpadFault fault, Instant now, double for_s) const;

  [[nodiscard]] bool active(TouchpadFault fault, Instant now) const;
  enum class Count { all, without_duration };
  /// How many faults of this kind have begun: for those that happen once.
  /// @param count without_duration: those that are over with the first that meets them; one with a duration is not made
  /// up for after its end by whoever asks then
  [[nodiscard]] int begun(TouchpadFault fault, Instant now, Count count = Count::all) const;

 private:
  struct Shared {
    std::mutex mutex;
    std::vector<TimedFault> faults;
  };
  std::shared_ptr<Shared> shared_;
  Instant start_{};
};

}  // namespace fyd::sim
