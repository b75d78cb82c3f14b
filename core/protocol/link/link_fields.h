// Fields that several messages of FYD Link share, written and read; inner part of the codec.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/protocol/byte_io.h"
#include "core/protocol/link/link_messages.h"
#include "core/protocol/link/link_refusal.h"

namespace fyd::protocol::fields {

inline constexpr double kMaximumTicks = 1e6;
inline constexpr double kMaximumStiffness = 1e6;
inline constexpr double kMaximumVibrationGain = 100.0;
inline constexpr double kMaximumRate_Hz = 10'000.0;
inline constexpr double kMaximumExtent_mm = 1e5;

/// `value` in steps of `step`, held at 0 and `most`; not a number is 0.
[[nodiscard]] inline std::uint64_t count(double value, double step, double most) {
  return std::isnan(value) ? 0 : static_cast<std::uint64_t>(std::clamp(std::round(value / step), 0.0, most));
}
[[nodiscard]] inline float held(double value, double least, double most) {
  return std::isnan(value) ? 0.0F : static_cast<float>(std::clamp(value, least, most));
}
/// False for NaN as well.
[[nodiscard]] inline bool within(double value, double least, double most) { return value >= least && value <= most; }

inline void writeOrientation(ByteWriter& out, const Orientation& o) {
  constexpr double kPerRadian = 65'536.0 / (2.0 * std::numbers::pi);
  for (const double angle : {o.alpha_rad, o.beta_rad, o.gamma_rad}) {
    const double turn = std::isfinite(angle) ? std::remainder(angle, 2.0 * std::numbers::pi) : 0.0;
    out.u16(static_cast<std::uint16_t>(static_cast<std::int32_t>(std::round(turn * kPerRadian))));
  }
}
[[nodiscard]] inline Orientation readOrientation(ByteReader& in) {
  constexpr double kRadians = 2.0 * std::numbers::pi / 65'536.0;
  const auto angle = [&] { return kRadians * static_cast<std::int16_t>(in.u16()); };
  const double alpha = angle();
  const double beta = angle();
  return {.alpha_rad = alpha, .beta_rad = beta, .gamma_rad = angle()};
}

inline void writeText(ByteWriter& out, std::string_view text, std::size_t most) {
  const std::size_t size = std::min(text.size(), most);
  out.u16(static_cast<std::uint16_t>(size));
  for (const char c : text.substr(0, size)) out.u8(static_cast<std::uint8_t>(c < ' ' || c > '~' ? '?' : c));
}
/// Printable ASCII only: what a peer calls itself ends up in logs and on the screen.
[[nodiscard]] inline bool readText(ByteReader& in, std::size_t most, std::string_view& text) {
  const std::size_t size = in.u16();
  const Bytes bytes = in.bytes(size);
  if (size > most || !std::ranges::all_of(bytes, [](std::uint8_t c) { return c >= ' ' && c <= '~'; })) return false;
  text = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  return true;
}

inline void writeVec3(ByteWriter& out, const Vec3& v) {
  for (const double c : {v.x, v.y, v.z}) out.f32(held(c, -kMaximumExtent_mm, kMaximumExtent_mm));
}
[[nodiscard]] inline Vec3 readVec3(ByteReader& in) {
  const double x = in.f32();
  const double y = in.f32();
  return {x, y, in.f32()};
}

inline void writeWorkspace(ByteWriter& out, const Workspace& w) {
  writeVec3(out, w.minimum_mm);
  writeVec3(out, w.maximum_mm);
  out.f32(held(w.precision_mm, 0.0, kMaximumExtent_mm));
}
[[nodiscard]] inline bool readWorkspace(ByteReader& in, Workspace& w) {
  w.minimum_mm = readVec3(in);
  w.maximum_mm = readVec3(in);
  w.precision_mm = in.f32();
  const auto inside = [](const Vec3& v) {
    return v.finite() && std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) <= kMaximumExtent_mm;
  };
  return inside(w.minimum_mm) && inside(w.maximum_mm) && within(w.precision_mm, 0.0, kMaximumExtent_mm) &&
         PositionCode::make(w).has_value();
}

inline void writeRates(ByteWriter& out, const Rates& rates) {
  for (const double rate : {rates.state_Hz, rates.touch_Hz}) {
    out.u16(static_cast<std::uint16_t>(std::max<std::uint64_t>(1, count(rate, 1.0, kMaximumRate_Hz))));
  }
}
[[nodiscard]] inline bool readRates(ByteReader& in, Rates& rates) {
  rates.state_Hz = in.u16();
  rates.touch_Hz = in.u16();
  return within(rates.state_Hz, 1.0, kMaximumRate_Hz) && within(rates.touch_Hz, 1.0, kMaximumRate_Hz);
}

inline void writeBoard(ByteWriter& out, double k_vib, const std::array<double, control::kMotorCount>& ticks,
                       std::string_view text) {
  out.f32(held(k_vib, 0.0, kMaximumVibrationGain));
  for (const double t : ticks) out.f32(held(t, -kMaximumTicks, kMaximumTicks));
  writeText(out, text, kMaximumBoardText);
}
[[nodiscard]] inline bool readBoard(ByteReader& in, double& k_vib, std::array<double, control::kMotorCount>& ticks,
                                    std::string_view& text) {
  k_vib = in.f32();
  bool good = within(k_vib, 0.0, kMaximumVibrationGain);
  for (double& t : ticks) {
    t = in.f32();
    good = within(t, -kMaximumTicks, kMaximumTicks) && good;
  }
  return readText(in, kMaximumBoardText, text) && good;
}

/// What every decoder ends with.
template <class T>
[[nodiscard]] LinkDecoded<T> finished(const ByteReader& in, const T& value, bool in_range) {
  if (!in.complete()) return {.refusal = LinkRefusal::size};
  if (!in_range) return {.refusal = LinkRefusal::field};
  return {.value = value};
}

}  // namespace fyd::protocol::fields
