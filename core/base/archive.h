// Serialises state (core/base/state.h) to bytes and back: cereal's binary archives, with checks that keep damaged bytes
// from becoming invalid values. Included only by the few .cpp files that make an archive.
#pragma once

#include <cstdint>
#include <stdexcept>

#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>

#include "core/base/time.h"

namespace fyd {

using StateWriter = cereal::BinaryOutputArchive;
using StateReader = cereal::BinaryInputArchive;

}  // namespace fyd

// Found by cereal through its archives' namespace.
namespace cereal {

inline void load(BinaryInputArchive& archive, bool& value) {
  std::uint8_t byte = 0;
  archive(byte);
  if (byte > 1) throw std::out_of_range("a truth value that is neither true nor false");
  value = byte == 1;
}

inline void save(BinaryOutputArchive& archive, const fyd::Instant& instant) {
  archive(std::int64_t{instant.time_since_epoch().count()});
}

inline void load(BinaryInputArchive& archive, fyd::Instant& instant) {
  constexpr std::int64_t kCentury_ns = 3'300'000'000'000'000'000;  // differences of two still fit
  std::int64_t count = 0;
  archive(count);
  if (count < -kCentury_ns || count > kCentury_ns) throw std::out_of_range("an instant more than a century away");
  instant = fyd::Instant(fyd::Duration(count));
}

}  // namespace cereal
