#include "core/recording/format/step_compare.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/recording/format/recording_format.h"

namespace fyd::recording {
namespace {

bool sameNumber(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

double distance(double a, double b) {
  const double out = std::abs(a - b);
  return std::isfinite(out) ? out : std::numeric_limits<double>::infinity();
}

/// Calls see(a's, b's) for each number of two commands.
template <class See>
void eachNumber(const control::MotorCommand& a, const control::MotorCommand& b, See&& see) {
  forEachField<control::MotorCommand>([&](auto, const auto& field) {
    if constexpr (std::is_scalar_v<FieldValue<decltype(field), control::MotorCommand>>)
      see(static_cast<double>(field.of(a)), static_cast<double>(field.of(b)));
    else
      for (std::size_t i = 0; i < field.of(a).size(); ++i)
        see(static_cast<double>(field.of(a)[i]), static_cast<double>(field.of(b)[i]));
  });
}

/// Sets the fields of `into` that the recording faults to those of `from`.
template <class T>
void take(const std::vector<std::string>& lacking, Table table, const T& from, T& into) {
  const std::string path = layoutOf(table).path;
  forEachField<T>([&](auto, const auto& field) {
    if constexpr (std::is_lvalue_reference_v<FieldResult<decltype(field), T>>)
      if (std::ranges::find(lacking, fmt::format("{} {}", path, field.name)) != lacking.end())
        field.of(into) = field.of(from);
  });
}

}  // namespace

void takeMissingColumns(const std::vector<std::string>& lacking, const pipeline::Outputs& computed,
                        StepRecord& recorded) {
  if (lacking.empty()) return;
  take(lacking, Table::telemetry, computed.telemetry, recorded.telemetry);
  take(lacking, Table::motors, computed.motors, recorded.motors);
}

bool sameStep(const pipeline::TelemetrySample& a, const control::MotorCommand& a_motors,
              const pipeline::TelemetrySample& b, const control::MotorCommand& b_motors) {
  return sameBits(a, b) && sameBits(a_motors, b_motors);
}

bool withinTolerance(const pipeline::ArithmeticTolerance& tolerance, const pipeline::TelemetrySample& a,
                     const control::MotorCommand& a_motors, const pipeline::TelemetrySample& b,
                     const control::MotorCommand& b_motors) {
  const auto close = [](double first, double second, double most) {
    return sameNumber(first, second) || (std::isnan(first) && std::isnan(second)) || distance(first, second) <= most;
  };
  if (a.now != b.now || a_motors.active != b_motors.active) return false;
  bool all_close = true;
  eachNumber(a_motors, b_motors, [&](double first, double second) {
    all_close = all_close && close(first, second, tolerance.of_a_command);
  });
  if (!all_close) return false;
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
    if (sameNumber(first, second)) return;
    const double absolute = distance(first, second);
    if (absolute < out.absolute) return;
    out = {.field = std::string(field), .absolute = absolute};
  };
  eachNumber(a_motors, b_motors, [&](double first, double second) { see("motors", first, second); });
  for (const pipeline::TelemetryField& field : pipeline::telemetryFields())
    see(field.name, field.read(a), field.read(b));
  return out;
}

}  // namespace fyd::recording
