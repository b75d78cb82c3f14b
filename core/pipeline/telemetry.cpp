#include "core/pipeline/telemetry.h"

#include <array>

namespace fyd::pipeline {
namespace {

constexpr std::size_t kInstants = 1;  // now_ns, the first field, is left out

template <std::size_t... I>
constexpr std::array<TelemetryField, sizeof...(I)> numbers(std::index_sequence<I...>) {
  constexpr auto of = [](const auto& field, double (*read)(const TelemetrySample&)) {
    return TelemetryField{field.name, field.unit, field.help, read};
  };
  return {of(std::get<I + kInstants>(kFieldsOf<TelemetrySample>), [](const TelemetrySample& sample) {
    return static_cast<double>(std::get<I + kInstants>(kFieldsOf<TelemetrySample>).of(sample));
  })...};
}

constexpr auto kNumbers = numbers(std::make_index_sequence<kFieldCount<TelemetrySample> - kInstants>());

}  // namespace

std::span<const TelemetryField> telemetryFields() { return kNumbers; }

}  // namespace fyd::pipeline
