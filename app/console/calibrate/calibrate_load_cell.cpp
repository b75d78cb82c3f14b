// The step that measures the load cell under known weights.
#include <cmath>
#include <random>

#include "app/console/calibrate/calibrate_step.h"
#include "core/base/units.h"
#include "core/calibration/load_cell_calibration.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {
namespace {

using widgets::tr;

constexpr int kLoadCurvePoints = 120;

class LoadCellStep : public CalibrationStep {
 public:
  QString id() const override { return QStringLiteral("load-cell"); }
  std::string procedure() const override { return "load-cell"; }
  std::string_view errorLimit() const override { return "calibration.force_held_out_N"; }
  QString instruction(const std::vector<CalibrationPoint>& points) const override {
    if (points.empty()) return tr("Leave the cell unloaded, type 0 and take the point.");
    return points.size() < 4
               ? tr("Put the next known weight on the cell, type it, wait until it rests, take the point.")
               : tr("Go on to the heaviest weight, then take the same weights off again one by one.");
  }
  QStringList columns() const override { return {tr("Bridge, mV/V"), tr("Force, N"), tr("Spread, mV/V")}; }
  std::vector<CalibrationEntry> entries() const override {
    return {{.name = tr("Weight"),
             .units = {QStringLiteral("N"), QStringLiteral("g")},
             .per_unit = {1.0, kStandardGravity / 1000.0},
             .lowest = 0.0,
             .highest = 100.0,
             .decimals = 3}};
  }
  std::vector<CalibrationSignal> signalsWanted(const station::Profile&) const override {
    constexpr double kMoving_mV_per_V = 0.02;  // 0.2 N with the thesis' cell, as for the tare
    return {{tr("Bridge"), QStringLiteral("mV/V"), 4, kMoving_mV_per_V}};
  }
  Result<std::vector<double>> read(const CalibrationScene& scene) const override {
    const auto value = liveValue(scene.devices, say("load cell"));
    if (!value) return tl::unexpected(value.error());
    const double span = sensing::LoadCell(scene.profile.step.sensing.load_cell).span_mV_per_V();
    if (!(std::abs(*value) <= span)) return fail("{:.3f} mV/V is beyond the load cell's span of {:g}", *value, span);
    return std::vector{*value};
  }

  CalibrationFit fit(const std::vector<CalibrationPoint>& points, const station::Profile& profile) const override {
    const auto& p = profile.calibration;
    if (points.empty()) {
      return noPoints(tr("At least %1 different weights that span %2 N.")
                          .arg(p.force_fewest_loads)
                          .arg(widgets::plainNumber(p.force_least_span_N)));
    }
    const auto found = calibration::calibrateLoadCell({columnOf(points, 0), columnOf(points, 1)}, p);
    CalibrationFit out =
        curveFit(found.result, points,
                 {.x_title = tr("Bridge, mV/V"), .y_title = tr("Force, N"), .residual_title = tr("Residual, N")});
    const auto [low, high] = std::ranges::minmax(columnOf(points, 0));
    if (std::isfinite(found.drift_N)) {
      out.figures << tr("drift from first to last point %1 ± %2")
                         .arg(widgets::numberText(found.drift_N, 3),
                              widgets::quantityText(found.drift_error_N, 3, QStringLiteral("N")));
    }
    if (std::isfinite(found.hysteresis_N)) {
      out.figures << tr("hysteresis %1").arg(widgets::quantityText(found.hysteresis_N, 3, QStringLiteral("N")));
    }
    if (!std::isfinite(found.drift_N) || !std::isfinite(found.hysteresis_N)) {
      out.figures << tr("take the weights off again one by one to see drift and hysteresis");
    }
    if (std::isfinite(found.repeatability_N)) {
      out.figures << tr("repeatability %1").arg(widgets::quantityText(found.repeatability_N, 3, QStringLiteral("N")));
    }
    const auto& former = profile.step.sensing.load_cell;
    for (const double x : {low, high}) {
      const double former_g = former.slope_g_per_mV_per_V * x + former.offset_g;
      out.plot.former_curve.emplace_back(x, former_g / 1000.0 * kStandardGravity);
      const auto& c = found.result.coefficients;
      if (c.size() == 2) out.plot.curve.emplace_back(x, c[0].value * x + c[1].value);
    }
    return out;
  }

  std::vector<CalibrationPoint> simulatedPoints(const station::Profile& profile) const override {
    const sensing::LoadCellParameters truth;  // the simulated cell is that of the thesis, whatever the profile holds
    std::mt19937_64 random(static_cast<std::uint64_t>(profile.sim.seed));
    std::normal_distribution<double> noise(0.0, profile.sim.bridge_noise_mV_per_V / std::sqrt(10.0));
    std::vector<CalibrationPoint> out;
    for (const double force_N : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 6.0, 4.0, 2.0, 0.0}) {
      const double grams = force_N * 1000.0 / kStandardGravity;
      const double value = (grams - truth.offset_g) / truth.slope_g_per_mV_per_V + profile.sim.bridge_offset_mV_per_V;
      out.push_back({value + noise(random), force_N, profile.sim.bridge_noise_mV_per_V});
    }
    return out;
  }
};

}  // namespace

CalibrationSteps loadCellSteps(const station::Profile&) { return oneStep<LoadCellStep>(); }

}  // namespace fyd::console
