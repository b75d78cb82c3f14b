// Tells sensors that go on delivering one and the same reading while their count says that it is new. The noise of real
// sensors makes that impossible (25 mV are 31 codes of a distance sensor, the bridge has 24 bits); a firmware whose
// sampling hangs while its registers live on delivers just that. Pure.
//
// An equal reading is believed for as long as device.frozen_reading_ms; after that it is no news: the last believed one
// stays with its old time, so that the step finds it stale. All distance sensors are looked at together (one alone is
// plausibility.h's). At the ends of a converter noise is cut off: such readings are passed on, the step calls them
// invalid.
#pragma once

#include <string>

#include "core/device/device_parameters.h"
#include "core/device/touchpad.h"

namespace fyd::device {

class FrozenReadings {
 public:
  explicit FrozenReadings(const DeviceParameters& parameters = {});

  /// @return the readings with frozen ones replaced by the last that was believed
  [[nodiscard]] TouchpadReadings check(const TouchpadReadings& readings);
  /// What is frozen and what to do; empty: nothing.
  [[nodiscard]] Message complaint() const;

 private:
  template <class T>
  struct Watch {
    Timed<T> seen;      // newest
    Timed<T> believed;  // handed on
    Instant changed{};  // when the seen value came first
    bool frozen = false;
  };
  template <class T>
  [[nodiscard]] const Timed<T>& follow(Watch<T>& watch, const Timed<T>& reading) const;

  Duration limit_;
  Watch<sensing::IrCounts> ir_;
  Watch<sensing::BridgeReading> bridge_;
};

}  // namespace fyd::device
