// Both FRI decoders on any bytes: refused, or finite, known, and stable when written and read again.
#include "core/protocol/fri_codec.h"

#include <cmath>

#include "tests/fuzz/fuzz.h"

using namespace fyd;
using namespace fyd::protocol;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes packet(data, size);
  FriMeasurement measurement;
  if (decodeFriMeasurement(packet, measurement) == FriRefusal::none) {
    fuzz::require(static_cast<int>(measurement.state) <= 2 && static_cast<int>(measurement.quality) <= 3);
    for (const float value : measurement.frame) fuzz::require(std::isfinite(value));
    const auto written = encodeFriMeasurement(measurement);
    FriMeasurement again;
    fuzz::require(decodeFriMeasurement(written, again) == FriRefusal::none);
    fuzz::require(encodeFriMeasurement(again) == written);
  }
  FriCommand command;
  if (decodeFriCommand(packet, command) == FriRefusal::none) {
    for (const float value : command.frame) fuzz::require(std::isfinite(value));
    const auto written = encodeFriCommand(command);
    FriCommand again;
    fuzz::require(decodeFriCommand(written, again) == FriRefusal::none);
    fuzz::require(encodeFriCommand(again) == written);
  }
  return 0;
}
