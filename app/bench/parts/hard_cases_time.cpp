// Time, counters and what goes over the wire.
#include <cmath>
#include <cstdint>

#include "app/bench/parts/hard_case.h"
#include "core/base/median.h"
#include "core/base/time.h"
#include "core/device/touchpad/modbus_touchpad.h"
#include "core/protocol/classic/classic_codec.h"
#include "core/protocol/position_code.h"

namespace fyd::bench {
namespace {

HardCase tenHoursOfMilliseconds() {
  constexpr int kSteps = 36'000'000;
  double naive_s = 0.0;
  Instant ours{};
  for (int i = 0; i < kSteps; ++i) {
    naive_s += 0.001;
    ours += std::chrono::milliseconds(1);
  }
  return {.name = "ten hours of steps of 1 ms, added up",
          .naive = "t += 0.001",
          .ours = "whole nanoseconds (`Instant`)",
          .truth = "exact: 36 000 s",
          .unit = "s",
          .naive_error = std::abs(naive_s - 36'000.0),
          .our_error = std::abs(toSeconds(ours - Instant{}) - 36'000.0),
          .at_most = 0.0};
}

HardCase hundredNanosecondsToday() {
  const std::int64_t now_ns = 1'764'000'000'123'456'789;
  const Instant before{std::chrono::nanoseconds(now_ns)}, after = before + std::chrono::nanoseconds(100);
  const double naive_s = 1e-9 * static_cast<double>(now_ns + 100) - 1e-9 * static_cast<double>(now_ns);
  return {.name = "100 ns between two instants of today",
          .naive = "seconds since 1970 as double, subtracted",
          .ours = "subtracted as whole nanoseconds (`toSeconds`)",
          .truth = "exact: 100 ns",
          .unit = "relative",
          .naive_error = std::abs(naive_s / 1e-7 - 1.0),
          .our_error = std::abs(toSeconds(after - before) / 1e-7 - 1.0),
          .at_most = 1e-15};
}

HardCase clockThatWraps() {
  // A day of cycles of 4 ms and a device clock of 32 bits in µs: it wraps each 71.6 minutes.
  HardCase out{.name = "a device clock of 32 bits over a day: restarts that were none",
               .naive = "it is smaller than before: restarted",
               .ours = "the difference modulo 2³² against the time that passed (`device::deviceRestarted`)",
               .truth = "64 bits: none",
               .unit = "in a day",
               .at_most = 0.0};
  std::uint64_t clock_us = 0;
  for (int i = 0; i < 24 * 3600 * 250; ++i) {
    const auto before = static_cast<std::uint32_t>(clock_us);
    clock_us += 4'000;
    const auto now = static_cast<std::uint32_t>(clock_us);
    out.naive_error += now < before ? 1.0 : 0.0;
    out.our_error += device::deviceRestarted(before, now, std::chrono::milliseconds(4)) ? 1.0 : 0.0;
  }
  return out;
}

HardCase forceBeyondItsField() {
  constexpr double kForce_N = 5.0, kMost_N = 3.2767;  // the field's largest
  pipeline::TouchMessage touch;
  touch.position_mm = {1.0, 1.0, -1.0};
  touch.in_contact = true;
  touch.force_N = kForce_N;
  const auto decoded = protocol::decodeTouch(protocol::encodeTouch(touch));
  const auto wrapped = static_cast<std::int16_t>(static_cast<std::uint16_t>(std::lround(kForce_N * 1e4)));
  return {.name = "5 N in the classic protocol's field of 16 bits",
          .naive = "converted to 16 bits: it wraps",
          .ours = "held at the largest (`protocol::encodeTouch`)",
          .truth = "the nearest that the field has: 3.2767 N",
          .unit = "N",
          .naive_error = std::abs(1e-4 * wrapped - kMost_N),
          .our_error = decoded.ok() ? std::abs(decoded.value.force_N - kMost_N) : kNotFinite,
          .at_most = 1e-9};
}

HardCase positionsInThirteenBits() {
  const protocol::Workspace workspace{{-80.0, -65.0, -65.0}, {80.0, 65.0, 65.0}, 0.02};
  const auto code = protocol::PositionCode::make(workspace);
  constexpr int kPositions = 400'000;
  double naive = 0.0, ours = 0.0;
  for (int i = 0; code && i < kPositions; ++i) {
    const double x = -80.0 + 160.0 * (i + 0.5) / kPositions;
    naive += (-80.0 + 0.02 * std::floor((x + 80.0) / 0.02) - x) / kPositions;
    if (const auto back = code->decode(code->encode({x, 0.0, 0.0}))) ours += (back->x - x) / kPositions;
  }
  return {.name = "mean error of positions that are sent in 13 bits",
          .naive = "truncated to the step",
          .ours = "the middle of the cell (`protocol::PositionCode`)",
          .truth = "symmetry: 0",
          .unit = "mm",
          .naive_error = std::abs(naive),
          .our_error = code ? std::abs(ours) : kNotFinite,
          .at_most = 1e-9};
}

HardCase middleOfHugeValues() {
  constexpr double kHuge = 1.5e308;
  const double naive = (kHuge + kHuge) / 2.0;
  return {.name = "median of two values of 1.5·10³⁰⁸",
          .naive = "half of their sum: it overflows",
          .ours = "`median`",
          .truth = "exact: 1.5·10³⁰⁸",
          .unit = "relative",
          .naive_error = std::isfinite(naive) ? std::abs(naive / kHuge - 1.0) : kNotFinite,
          .our_error = std::abs(median({kHuge, kHuge}) / kHuge - 1.0),
          .at_most = 1e-15};
}

}  // namespace

std::vector<HardCase> hardCasesOfTimeAndCodes() {
  return {tenHoursOfMilliseconds(), hundredNanosecondsToday(), clockThatWraps(),
          forceBeyondItsField(),    positionsInThirteenBits(), middleOfHugeValues()};
}

}  // namespace fyd::bench
