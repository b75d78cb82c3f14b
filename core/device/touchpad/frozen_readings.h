// Detects frozen sensors: readings that stay equal while their count says that they are new. The noise of real sensors
// makes that impossible (25 mV are 31 codes of a distance sensor, the bridge has 24 bits). The cause is a firmware
// whose sampling hangs while its registers are still served. Pure.
//
// Equal readings are accepted for device.frozen_reading_ms. After that the last accepted one is passed on with its old
// time, so that the step finds it stale. All distance sensors are judged together (a single one: plausibility.h). At
// the ends of a converter's range noise is cut off: such readings are passed on, and the step treats them as invalid.
#pragma once

#include <string>

#include "core/device/device_parameters.h"
#include "core/device/touchpad/touchpad.h"

namespace fyd::device {

class FrozenReadings {
 public:
  explicit FrozenReadings(const DeviceParameters& parameters = {});

  /// @return the readings with frozen ones replaced by the last accepted
  [[nodiscard]] TouchpadReadings check(const TouchpadReadings& readings);
  /// What is frozen and what to do; empty: nothing.
  [[nodiscard]] Message complaint() const;

 private:
  template <class T>
  struct Watch {
    Timed<T> seen;      // newest
    Timed<T> believed;  // passed on
    Instant changed{};  // when the present value came first
    bool frozen = false;
  };
  template <class T>
  [[nodiscard]] const Timed<T>& follow(Watch<T>& watch, const Timed<T>& reading) const;

  Duration limit_;
  Watch<sensing::IrCounts> ir_;
  Watch<sensing::BridgeReading> bridge_;
};

}  // namespace fyd::device
