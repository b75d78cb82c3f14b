// What two linked devices tell each other: the tele-gesture paper's message (x, y, z, α, β, γ, force, date), with the
// bits of `fyd budget`: 13 an axis for the desktop arm, 16 an angle, 16 a component of force. What couplings need
// besides is added only where there is something to say: energies (time-domain passivity), a surface that is known.
// With a deadband (teleop/deadband.h) messages are numbered, say how fast the device moves, and repeat the two before.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/base/batch.h"
#include "core/protocol/link/link_messages.h"
#include "core/protocol/position_code.h"
#include "core/teleop/coupling/coupling.h"

namespace fyd::protocol {

/// Where a device was and what it felt at one moment.
struct DeviceSample {
  double date_s = 0.0;
  Vec3 position_mm;
  Vec3 velocity_mm_per_s;  ///< ±3276.7, 0.1 mm/s steps
  Vec3 force_N;            ///< ±32.767, 1 mN steps
};

struct DeviceMessage {
  static constexpr std::size_t kEarlier = 2;

  std::uint16_t session = 0;  ///< of the sender, another one with each start
  bool running = true;        ///< false: it has been stopped
  double date_s = 0.0;        ///< 0 … 8.9 years, in µs
  Vec3 position_mm;
  Orientation orientation;
  Vec3 force_N;               ///< ±32.767, 1 mN steps
  bool tells_energy = false;  ///< the axes' energies are sent
  /// 0: no deadband, and none of the following three is told.
  std::uint32_t number = 0;
  Vec3 velocity_mm_per_s;
  /// Those of the two messages before this one, the oldest first; the age of each up to 16.7 s, in µs.
  Batch<DeviceSample, kEarlier> earlier;
  /// Per axis: the fields of CouplingMessage other than date and position.
  std::array<teleop::CouplingMessage, 3> axes;
};

inline constexpr std::size_t kMostDeviceMessage = 120;

/// @return its size; 0 when it does not fit
std::size_t encode(const DeviceMessage& message, const PositionCode& code, std::span<std::uint8_t> out);
/// @return nothing when it is no such message
[[nodiscard]] std::optional<DeviceMessage> decodeDeviceMessage(std::span<const std::uint8_t> bytes,
                                                               const PositionCode& code);

}  // namespace fyd::protocol
