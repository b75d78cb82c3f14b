#include "core/sim/device_message.h"

#include <algorithm>
#include <cmath>

#include "core/protocol/byte_io.h"
#include "core/protocol/link_fields.h"

namespace fyd::sim {
namespace {

using namespace protocol;

constexpr std::uint16_t kMagic = 0x4454;                                                  // "TD"
constexpr std::uint8_t kRunning = 1, kEnergies = 2, kFirstSurface = 4, kFirstTouch = 32;  // three bits each
constexpr double kMost_N = 32.767, kForceStep_N = 1e-3;
constexpr double kMost_us = 281'474'976'710'655.0;  // 48 bits
constexpr int kPositionBytes = 5;                   // 39 bits

std::uint8_t flag(std::uint8_t first, std::size_t axis) { return static_cast<std::uint8_t>(first << axis); }

}  // namespace

std::size_t encode(const DeviceMessage& message, const PositionCode& code, std::span<std::uint8_t> out) {
  ByteWriter writer(out);
  auto flags = static_cast<std::uint8_t>((message.running ? kRunning : 0) | (message.tells_energy ? kEnergies : 0));
  for (std::size_t a = 0; a < 3; ++a) {
    if (message.axes[a].knows_surface) flags |= flag(kFirstSurface, a);
    if (message.axes[a].touching) flags |= flag(kFirstTouch, a);
  }
  writer.u16(kMagic);
  writer.u8(flags);
  writer.u16(message.session);
  writer.u48(static_cast<std::uint64_t>(
      std::clamp(std::isfinite(message.date_s) ? std::round(1e6 * message.date_s) : 0.0, 0.0, kMost_us)));
  writer.little<kPositionBytes>(code.encode(message.position_mm));
  fields::writeOrientation(writer, message.orientation);
  for (const double force : {message.force_N.x, message.force_N.y, message.force_N.z}) {
    const double held = std::isfinite(force) ? std::clamp(force, -kMost_N, kMost_N) : 0.0;
    writer.u16(static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(held / kForceStep_N))));
  }
  for (const teleop::CouplingMessage& axis : message.axes) {
    if (message.tells_energy) writer.f32(static_cast<float>(axis.energy_J));
    if (!axis.knows_surface) continue;
    writer.f32(static_cast<float>(axis.surface_m));
    writer.f32(static_cast<float>(axis.stiffness_N_per_m));
  }
  return writer.size();
}

std::optional<DeviceMessage> decodeDeviceMessage(std::span<const std::uint8_t> bytes, const PositionCode& code) {
  ByteReader in(bytes);
  if (in.u16() != kMagic) return std::nullopt;
  DeviceMessage out;
  const std::uint8_t flags = in.u8();
  out.running = (flags & kRunning) != 0;
  out.tells_energy = (flags & kEnergies) != 0;
  out.session = in.u16();
  out.date_s = 1e-6 * static_cast<double>(in.u48());
  const auto position = code.decode(in.little<kPositionBytes>());
  out.orientation = fields::readOrientation(in);
  for (double* force : {&out.force_N.x, &out.force_N.y, &out.force_N.z}) {
    *force = kForceStep_N * static_cast<std::int16_t>(in.u16());
  }
  for (std::size_t a = 0; a < out.axes.size(); ++a) {
    teleop::CouplingMessage& axis = out.axes[a];
    axis.touching = (flags & flag(kFirstTouch, a)) != 0;
    axis.knows_surface = (flags & flag(kFirstSurface, a)) != 0;
    if (out.tells_energy) axis.energy_J = static_cast<double>(in.f32());
    if (!axis.knows_surface) continue;
    axis.surface_m = static_cast<double>(in.f32());
    axis.stiffness_N_per_m = static_cast<double>(in.f32());
  }
  if (!in.complete() || !position) return std::nullopt;
  out.position_mm = *position;
  return out;
}

}  // namespace fyd::sim
