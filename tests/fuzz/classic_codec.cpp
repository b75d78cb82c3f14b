// Every decoder of the classic codec on any bytes: refused, or well-formed and stable when written and read again.
#include "core/protocol/classic/classic_codec.h"

#include <cmath>

#include "tests/fuzz/fuzz.h"

using namespace fyd;
using namespace fyd::protocol;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes packet(data, size);
  static_cast<void>(isAck(packet));
  static_cast<void>(looksLikeState(packet));
  if (const auto state = decodeState(packet); state.ok()) {
    fuzz::require(state.value.acceleration_g.finite() && state.value.robot.position_mm.finite());
    fuzz::require(state.value.robot.stiffness_N_per_mm >= 0.0 && state.value.robot.stiffness_N_per_mm <= 6.5535);
    fuzz::require(static_cast<int>(state.value.command) <= 11);
    const auto written = encodeState(state.value);
    const auto again = decodeState(written);
    fuzz::require(again.ok() && encodeState(again.value) == written);
  }
  if (const auto touch = decodeTouch(packet); touch.ok()) {
    fuzz::require(touch.value.position_mm.finite() && touch.value.force_N >= 0.0);
    const auto written = encodeTouch(touch.value);
    const auto again = decodeTouch(written);
    fuzz::require(again.ok() && encodeTouch(again.value) == written);
  }
  if (const auto info = decodeInfoValues(packet); info.ok()) {
    const auto written = encodeInfoValues(info.value);
    fuzz::require(encodeInfoValues(decodeInfoValues(written).value) == written);
  }
  if (const auto reference = decodeMotorReference(packet); reference.ok()) {
    const auto written = encodeMotorReference(reference.value);
    fuzz::require(encodeMotorReference(decodeMotorReference(written).value) == written);
  }
  if (const auto length = decodeInfoLength(packet); length.ok()) {
    fuzz::require(decodeInfoLength(encodeInfoLength(length.value)).value == length.value);
  }
  if (const auto length = decodeImageLength(packet); length.ok()) {
    fuzz::require(decodeImageLength(encodeImageLength(length.value)).value == length.value);
  }
  return 0;
}
