#include "core/recording/format/recording_overview.h"

namespace fyd::recording {
namespace {

void widen(double& low, double& high, double new_low, double new_high) {
  // fmin and fmax take the number when the other is NaN: exactly what "left out" means.
  low = std::fmin(low, new_low);
  high = std::fmax(high, new_high);
}

}  // namespace

void OverviewRow::clear() { values_.assign(2 * pipeline::telemetryFields().size(), pipeline::kNone); }

void OverviewRow::take(const pipeline::TelemetrySample& sample) {
  const auto fields = pipeline::telemetryFields();
  for (std::size_t field = 0; field < fields.size(); ++field) {
    const double value = fields[field].read(sample);
    widen(values_[2 * field], values_[2 * field + 1], value, value);
  }
}

void OverviewRow::take(const OverviewRow& finer) {
  for (std::size_t i = 0; i < values_.size(); i += 2)
    widen(values_[i], values_[i + 1], finer.values_[i], finer.values_[i + 1]);
}

}  // namespace fyd::recording
