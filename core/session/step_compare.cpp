#include "core/session/step_compare.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace fyd::session {
namespace {

bool sameBits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

double distance(double a, double b) {
  const double out = std::abs(a - b);
  return std::isfinite(out) ? out : std::numeric_limits<double>::infinity();
}

}  // namespace

bool sameStep(const pipeline::TelemetrySample& a, const control::MotorCommand& a_motors,
              const pipeline::TelemetrySample& b, const control::MotorCommand& b_motors) {
  if (a.now != b.now) return false;
  for (const pipeline::TelemetryField& field : pipeline::telemetryFields()) {
    if (!sameBits(field.read(a), field.read(b))) return false;
  }
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    if (!sameBits(a_motors.vibration_duty_percent[i], b_motors.vibration_duty_percent[i])) return false;
  }
  return a_motors.reference_ticks == b_motors.reference_ticks && a_motors.active == b_motors.active;
}

bool withinTolerance(const pipeline::ArithmeticTolerance& tolerance, const pipeline::TelemetrySample& a,
                     const control::MotorCommand& a_motors, const pipeline::TelemetrySample& b,
                     const control::MotorCommand& b_motors) {
  const auto close = [](double first, double second, double most) {
    return sameBits(first, second) || (std::isnan(first) && std::isnan(second)) || distance(first, second) <= most;
  };
  if (a.now != b.now || a_motors.active != b_motors.active) return false;
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    if (!close(a_motors.reference_ticks[i], b_motors.reference_ticks[i], tolerance.of_a_command)) return false;
    if (!close(a_motors.vibration_duty_percent[i], b_motors.vibration_duty_percent[i], tolerance.of_a_command))
      return false;
  }
  for (const pipeline::TelemetryField& field : pipeline::telemetryFields()) {
    const bool command = field.name == "vibration_duty_percent";
    if (!close(field.read(a), field.read(b), command ? tolerance.of_a_command : tolerance.of_a_field)) return false;
  }
  return true;
}

std::optional<StepDifference> compareSteps(const pipeline::TelemetrySample& a, const control::MotorCommand& a_motors,
                                           const pipeline::TelemetrySample& b, const control::MotorCommand& b_motors) {
  if (sameStep(a, a_motors, b, b_motors)) return std::nullopt;
  StepDifference out{.field = "motors"};
  const auto see = [&out](std::string_view field, double first, double second) {
    if (sameBits(first, second)) return;
    const double absolute = distance(first, second);
    if (absolute < out.absolute) return;
    out = {.field = std::string(field), .absolute = absolute};
  };
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    see("motors", a_motors.reference_ticks[i], b_motors.reference_ticks[i]);
    see("motors", a_motors.vibration_duty_percent[i], b_motors.vibration_duty_percent[i]);
  }
  see("motors", a_motors.active ? 1.0 : 0.0, b_motors.active ? 1.0 : 0.0);
  for (const pipeline::TelemetryField& field : pipeline::telemetryFields())
    see(field.name, field.read(a), field.read(b));
  return out;
}

}  // namespace fyd::session
