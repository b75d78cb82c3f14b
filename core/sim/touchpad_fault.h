// Faults that the simulated touchpad shows on demand, each at its time.
#pragma once

#include <array>
#include <limits>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/time.h"

namespace fyd::sim {

enum class TouchpadFault : std::uint8_t {
  late_reply,     ///< answers come 250 ms late; without a duration one of them
  silence,        ///< no answers
  stuck_sensor,   ///< IR sensor 1 goes on saying what it last said
  brown_out,      ///< the supply breaks down (0.5 s without a duration): silence, then a restart with the motors off
  encoder_jump,   ///< encoder 1 counts 512 too many
  camera_freeze,  ///< the camera's stream goes on with the same picture
  garbage,        ///< random bytes in place of answers
};
inline constexpr std::array<std::string_view, 7> kTouchpadFaultNames = {
    "late-reply", "silence", "stuck-sensor", "brown-out", "encoder-jump", "camera-freeze", "garbage"};

inline constexpr Duration kLateBy = std::chrono::milliseconds(250);

struct TimedFault {
  TouchpadFault fault{};
  double at_s = 0.0;
  double for_s = std::numeric_limits<double>::infinity();
};

/// Reads "NAME@T" or "NAME@T+D", seconds. A late reply without D lasts for one answer, a brown-out for 0.5 s, any other
/// fault to the end.
[[nodiscard]] Result<TimedFault> parseTimedFault(std::string_view text);

/// Immutable: may be asked from any thread.
class FaultPlan {
 public:
  FaultPlan() = default;
  FaultPlan(std::vector<TimedFault> faults, Instant start) : faults_(std::move(faults)), start_(start) {}

  [[nodiscard]] bool active(TouchpadFault fault, Instant now) const;
  /// How many faults of this kind have begun: for those that happen once.
  [[nodiscard]] int begun(TouchpadFault fault, Instant now) const;

 private:
  std::vector<TimedFault> faults_;
  Instant start_{};
};

}  // namespace fyd::sim
