// A touchpad that is silent for longer than its watchdog has switched its motors off by itself, and follows no command
// until one was off: it must not begin to move when it comes back. The session's Held, which keeps the motors on, would
// be that command for ever. So, once the board has been silent for that long while Held, the command is off until the
// operator's next arm, which switches the motors on as the first arm did.
#pragma once

#include "core/base/time.h"
#include "core/pipeline/safety.h"

namespace fyd::station {

class MotorRelease {
 public:
  /// @param watchdog after which the board switches its motors off by itself
  explicit MotorRelease(Duration watchdog) : watchdog_(watchdog) {}

  /// @param silence age of the motors' newest values
  /// @return whether the motors are given up: the command is to be off
  [[nodiscard]] bool step(pipeline::SafetyState state, Duration silence) {
    released_ = state == pipeline::SafetyState::held && (released_ || silence > watchdog_);
    return released_;
  }

 private:
  Duration watchdog_;
  bool released_ = false;
};

}  // namespace fyd::station
