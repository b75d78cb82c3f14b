#include "core/protocol/link/device_message.h"

#include <algorithm>
#include <cmath>

#include "core/protocol/byte_io.h"
#include "core/protocol/link/link_fields.h"

namespace fyd::protocol {
namespace {

constexpr std::uint16_t kMagic = 0x4454, kNumberedMagic = 0x4E54;                         // "TD", "TN"
constexpr std::uint8_t kRunning = 1, kEnergies = 2, kFirstSurface = 4, kFirstTouch = 32;  // three bits each
constexpr double kMost_N = 32.767, kForceStep_N = 1e-3;
constexpr double kMost_mm_per_s = 3276.7, kSpeedStep_mm_per_s = 0.1;
constexpr double kMostAge_us = 16'777'215.0;        // 24 bits
constexpr double kMost_us = 281'474'976'710'655.0;  // 48 bits
constexpr int kPositionBytes = 5;                   // 39 bits

std::uint8_t flag(std::uint8_t first, std::size_t axis) { return static_cast<std::uint8_t>(first << axis); }

void writeSteps(ByteWriter& writer, const Vec3& value, double most, double step) {
  for (const double each : {value.x, value.y, value.z}) {
    const double held = std::isfinite(each) ? std::clamp(each, -most, most) : 0.0;
    writer.u16(static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(held / step))));
  }
}

Vec3 readSteps(ByteReader& in, double step) {
  Vec3 out;
  for (double* each : {&out.x, &out.y, &out.z}) *each = step * static_cast<std::int16_t>(in.u16());
  return out;
}

std::uint64_t microseconds(double seconds, double most_us) {
  return static_cast<std::uint64_t>(std::clamp(std::isfinite(seconds) ? std::round(1e6 * seconds) : 0.0, 0.0, most_us));
}

}  // namespace

std::size_t encode(const DeviceMessage& message, const PositionCode& code, std::span<std::uint8_t> out) {
  ByteWriter writer(out);
  auto flags = static_cast<std::uint8_t>((message.running ? kRunning : 0) | (message.tells_energy ? kEnergies : 0));
  for (std::size_t a = 0; a < 3; ++a) {
    if (message.axes[a].knows_surface) flags |= flag(kFirstSurface, a);
    if (message.axes[a].touching) flags |= flag(kFirstTouch, a);
  }
  writer.u16(message.number > 0 ? kNumberedMagic : kMagic);
  writer.u8(flags);
  writer.u16(message.session);
  writer.u48(microseconds(message.date_s, kMost_us));
  writer.little<kPositionBytes>(code.encode(message.position_mm));
  fields::writeOrientation(writer, message.orientation);
  writeSteps(writer, message.force_N, kMost_N, kForceStep_N);
  for (const teleop::CouplingMessage& axis : message.axes) {
    if (message.tells_energy) writer.f32(static_cast<float>(axis.energy_J));
    if (!axis.knows_surface) continue;
    writer.f32(static_cast<float>(axis.surface_m));
    writer.f32(static_cast<float>(axis.stiffness_N_per_m));
  }
  if (message.number == 0) return writer.size();
  writer.u32(message.number);
  writeSteps(writer, message.velocity_mm_per_s, kMost_mm_per_s, kSpeedStep_mm_per_s);
  for (const DeviceSample& each : message.earlier) {
    writer.little<3>(microseconds(message.date_s - each.date_s, kMostAge_us));
    writer.little<kPositionBytes>(code.encode(each.position_mm));
    writeSteps(writer, each.velocity_mm_per_s, kMost_mm_per_s, kSpeedStep_mm_per_s);
    writeSteps(writer, each.force_N, kMost_N, kForceStep_N);
  }
  return writer.size();
}

std::optional<DeviceMessage> decodeDeviceMessage(std::span<const std::uint8_t> bytes, const PositionCode& code) {
  ByteReader in(bytes);
  const std::uint16_t magic = in.u16();
  if (magic != kMagic && magic != kNumberedMagic) return std::nullopt;
  DeviceMessage out;
  const std::uint8_t flags = in.u8();
  out.running = (flags & kRunning) != 0;
  out.tells_energy = (flags & kEnergies) != 0;
  out.session = in.u16();
  out.date_s = 1e-6 * static_cast<double>(in.u48());
  const auto position = code.decode(in.little<kPositionBytes>());
  out.orientation = fields::readOrientation(in);
  out.force_N = readSteps(in, kForceStep_N);
  for (std::size_t a = 0; a < out.axes.size(); ++a) {
    teleop::CouplingMessage& axis = out.axes[a];
    axis.touching = (flags & flag(kFirstTouch, a)) != 0;
    axis.knows_surface = (flags & flag(kFirstSurface, a)) != 0;
    if (out.tells_energy) axis.energy_J = static_cast<double>(in.f32());
    if (!axis.knows_surface) continue;
    axis.surface_m = static_cast<double>(in.f32());
    axis.stiffness_N_per_m = static_cast<double>(in.f32());
  }
  if (magic == kNumberedMagic) {
    out.number = in.u32();
    if (out.number == 0) return std::nullopt;
    out.velocity_mm_per_s = readSteps(in, kSpeedStep_mm_per_s);
    while (in.left() > 0 && out.earlier.size() < std::min<std::size_t>(out.number - 1, DeviceMessage::kEarlier)) {
      DeviceSample each{.date_s = out.date_s - 1e-6 * static_cast<double>(in.little<3>())};
      const auto at = code.decode(in.little<kPositionBytes>());
      if (!at) return std::nullopt;
      each.position_mm = *at;
      each.velocity_mm_per_s = readSteps(in, kSpeedStep_mm_per_s);
      each.force_N = readSteps(in, kForceStep_N);
      static_cast<void>(out.earlier.push(each));
    }
  }
  if (!in.complete() || !position) return std::nullopt;
  out.position_mm = *position;
  return out;
}

}  // namespace fyd::protocol
