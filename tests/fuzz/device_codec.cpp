// What two linked devices tell each other, of any bytes: refused, or finite and stable when written and read again.
#include "core/protocol/link/device_message.h"

#include <array>
#include <cmath>

#include "core/protocol/link/link_codec.h"
#include "tests/fuzz/fuzz.h"

using namespace fyd;

namespace {

bool finite(const protocol::DeviceMessage& message) {
  bool good = message.position_mm.finite() && message.force_N.finite() && message.velocity_mm_per_s.finite() &&
              std::isfinite(message.date_s) && std::isfinite(message.orientation.alpha_rad) &&
              std::isfinite(message.orientation.beta_rad) && std::isfinite(message.orientation.gamma_rad);
  for (const protocol::DeviceSample& each : message.earlier) {
    good = good && std::isfinite(each.date_s) && each.position_mm.finite() && each.velocity_mm_per_s.finite();
  }
  return good;
}

void readAndWrite(std::span<const std::uint8_t> bytes, const protocol::PositionCode& code) {
  const auto message = protocol::decodeDeviceMessage(bytes, code);
  if (!message) return;
  fuzz::require(finite(*message));
  std::array<std::uint8_t, protocol::kMostDeviceMessage> written{}, again{};
  const std::size_t size = encode(*message, code, written);
  fuzz::require(size == bytes.size());
  const auto read = protocol::decodeDeviceMessage(std::span(written).first(size), code);
  fuzz::require(read && read->number == message->number && read->earlier.size() == message->earlier.size());
  fuzz::require(encode(*read, code, again) == size && again == written);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto code = *protocol::PositionCode::make(protocol::asOnTheWire(protocol::TouchpadHello{}.workspace));
  readAndWrite({data, size}, code);
  return 0;
}
