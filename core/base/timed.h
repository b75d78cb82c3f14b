// A value together with the instant it was taken: every input of the step is one of these.
// Stability: stable since 0.1
#pragma once

#include <cstdint>

#include "core/base/time.h"

namespace fyd {

enum class Freshness : std::uint8_t {
  never,   ///< no value was ever taken
  fresh,   ///< taken within the allowed age
  stale,   ///< older than the allowed age
  future,  ///< stamped later than now: the clock went backwards, or the source's stamp is wrong
};

/// A state-like input. `count` is 0 until the first value and grows by one with each new one,
/// so a reader knows whether it has seen this value before.
template <class T>
struct Timed {
  T value{};
  Instant taken{};
  std::uint64_t count = 0;

  [[nodiscard]] Duration age(Instant now) const { return now - taken; }

  /// Values up to 1 ms ahead of `now` count as fresh: they were taken while the step was being called.
  [[nodiscard]] Freshness freshness(Instant now, Duration maximum_age) const {
    if (count == 0) return Freshness::never;
    if (taken > now + std::chrono::milliseconds(1)) return Freshness::future;
    return age(now) <= maximum_age ? Freshness::fresh : Freshness::stale;
  }

  void set(const T& new_value, Instant when) {
    value = new_value;
    taken = when;
    ++count;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(value, taken, count);
  }
};

}  // namespace fyd
