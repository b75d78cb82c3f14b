// The figure of a report: force, indentation, stiffness with its target, vibration over the whole recording.
#include <algorithm>

#include "core/report/report_content.h"

namespace fyd::report {
namespace {

Result<ChartCurve> curveOf(const recording::Recording& recording, std::string_view name, Rgb colour, bool dashed) {
  const auto fields = pipeline::telemetryFields();
  const auto field = std::ranges::find(fields, name, &pipeline::TelemetryField::name);
  auto overview = recording.overview(static_cast<std::size_t>(field - fields.begin()), 0.0, recording.info().duration_s,
                                     kCurveBuckets);
  if (!overview) return tl::unexpected(overview.error());
  return ChartCurve{.values = std::move(*overview), .colour = colour, .dashed = dashed};
}

}  // namespace

Result<void> gatherStrips(const recording::Recording& recording, ReportContent& content) {
  content.time.range = {0.0, recording.info().duration_s};
  if (recording.info().committed_samples == 0) {
    content.legend = "The recording holds no sample.";
    return {};
  }
  struct Wanted {
    const char* title;
    const char* field;
    const char* target;
    Rgb colour;
  };
  constexpr Wanted kWanted[] = {
      {"Force, N", "force_N", nullptr, kForceRgb},
      {"Indentation, mm", "indentation_mm", nullptr, kIndentationRgb},
      {"Stiffness, N/mm (dashed: reachable target)", "stiffness_N_per_mm", "reachable_target_N_per_mm", kStiffnessRgb},
      {"Vibration duty, %", "vibration_duty_percent", nullptr, kVibrationRgb}};
  for (const Wanted& wanted : kWanted) {
    ChartStrip strip{.title = wanted.title, .colour = wanted.colour};
    auto curve = curveOf(recording, wanted.field, wanted.colour, false);
    if (!curve) return tl::unexpected(curve.error());
    strip.curves.push_back(std::move(*curve));
    if (wanted.target != nullptr) {
      auto target = curveOf(recording, wanted.target, kTextRgb, true);
      if (!target) return tl::unexpected(target.error());
      strip.curves.push_back(std::move(*target));
    }
    content.strips.push_back(std::move(strip));
  }
  content.legend =
      "Shaded: touches. Red bands: samples lost. Numbered lines: the log below, red where the session was held or "
      "stopped. Stiffness holds its last value while it cannot be observed.";
  return {};
}

}  // namespace fyd::report
