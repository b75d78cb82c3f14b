#include "core/device/touchpad/frozen_readings.h"

#include <algorithm>
#include <cmath>

#include "core/sensing/load_cell.h"

namespace fyd::device {
namespace {

constexpr std::uint16_t kLargestCode = 4095;

/// Equal codes, of which at least one is not at an end of the converter's range.
bool same(const sensing::IrCounts& a, const sensing::IrCounts& b) {
  return std::ranges::equal(a.view(), b.view()) &&
         std::ranges::any_of(b.view(), [](std::uint16_t code) { return code != 0 && code != kLargestCode; });
}

bool same(const sensing::BridgeReading& a, const sensing::BridgeReading& b) {
  return a.value_mV_per_V == b.value_mV_per_V && std::abs(b.value_mV_per_V) < sensing::kConverterEnd_mV_per_V;
}

}  // namespace

FrozenReadings::FrozenReadings(const DeviceParameters& parameters)
    : limit_(fromSeconds(parameters.frozen_reading_ms / 1e3)) {}

template <class T>
const Timed<T>& FrozenReadings::follow(Watch<T>& watch, const Timed<T>& reading) const {
  if (limit_ <= Duration::zero()) return reading;
  if (reading.count == watch.seen.count) return watch.believed;
  const bool repeated = watch.seen.count > 0 && same(watch.seen.value, reading.value);
  watch.seen = reading;
  if (!repeated) watch.changed = reading.taken;
  watch.frozen = reading.taken - watch.changed > limit_;
  if (!watch.frozen) watch.believed = reading;
  return watch.believed;
}

TouchpadReadings FrozenReadings::check(const TouchpadReadings& readings) {
  return {.ir = follow(ir_, readings.ir), .bridge = follow(bridge_, readings.bridge), .motors = readings.motors};
}

Message FrozenReadings::complaint() const {
  if (ir_.frozen) {
    return say("the distance sensors repeat the codes {} although their count goes on: switch the touchpad off and on",
               fmt::join(ir_.seen.value.view(), ", "));
  }
  if (bridge_.frozen) {
    return say("the load cell repeats {} mV/V although its count goes on: switch the touchpad off and on",
               bridge_.seen.value.value_mV_per_V);
  }
  return {};
}

}  // namespace fyd::device
