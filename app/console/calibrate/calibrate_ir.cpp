// The steps that measure each distance sensor at known distances.
#include <algorithm>
#include <cmath>
#include <random>

#include "app/console/calibrate/calibrate_step.h"
#include "core/calibration/ir_calibration.h"
#include "core/sim/touchpad/ir_sensor.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {
namespace {

using widgets::tr;

constexpr int kCurvePoints = 120;

class IrStep : public CalibrationStep {
 public:
  explicit IrStep(std::size_t sensor) : sensor_(sensor) {}
  QString id() const override { return QStringLiteral("ir-%1").arg(sensor_ + 1); }
  std::string procedure() const override { return "ir"; }
  std::string_view errorLimit() const override { return "calibration.ir_held_out_mm"; }
  int sensor() const override { return static_cast<int>(sensor_ + 1); }
  QString instruction(const std::vector<CalibrationPoint>& points) const override {
    return points.empty()
               ? tr("Hold a flat white target over the sensor, measure its distance, type it and take the point.")
               : tr("Move the target by some 20 mm, type the new distance and take the next point, 40 to 300 mm.");
  }
  QStringList columns() const override { return {tr("Reading, counts"), tr("Distance, mm"), tr("Spread, counts")}; }
  std::vector<CalibrationEntry> entries() const override {
    return {{.name = tr("Distance"),
             .units = {QStringLiteral("mm"), QStringLiteral("cm")},
             .per_unit = {1.0, 10.0},
             .lowest = 1.0,
             .highest = 1000.0,
             .decimals = 1}};
  }
  std::vector<CalibrationSignal> signalsWanted(const station::Profile&) const override {
    constexpr double kMoving_counts = 50.0;  // four times the noise of 10 mV
    return {{tr("Reading"), tr("counts"), 1, kMoving_counts}};
  }
  Result<std::vector<double>> read(const CalibrationScene& scene) const override {
    const auto value = liveValue(scene.devices, say("IR sensor {}", sensor_ + 1));
    if (!value) return tl::unexpected(value.error());
    return std::vector{*value};
  }

  CalibrationFit fit(const std::vector<CalibrationPoint>& points, const station::Profile& profile) const override {
    const auto& p = profile.calibration;
    if (points.empty()) {
      return noPoints(tr("At least %1 different distances that span %2 mm.")
                          .arg(p.ir_fewest_distances)
                          .arg(widgets::plainNumber(p.ir_least_span_mm)));
    }
    const auto& present = profile.step.sensing.indentation;
    const auto found =
        calibration::calibrateIr({columnOf(points, 0), columnOf(points, 1)}, present, p, {.sensor = sensor_});
    CalibrationFit out = curveFit(
        found.result, points,
        {.x_title = tr("Reading, counts"), .y_title = tr("Distance, mm"), .residual_title = tr("Residual, mm")});
    const auto [low, high] = std::ranges::minmax(columnOf(points, 0));
    const sensing::IrDistance former = distanceSensorOf(present, sensor_);
    const auto fitted = found.curve.sensor(0, sensing::kAdcCodes - 1);
    for (int i = 0; i <= kCurvePoints; ++i) {
      const double code = low + (high - low) * i / kCurvePoints;
      const double volts = sensing::voltsFromCode(code);
      out.plot.former_curve.emplace_back(code, former.distance_mm(volts));
      if (!found.curve.coefficients.empty()) out.plot.curve.emplace_back(code, fitted.distance_mm(volts));
    }
    return out;
  }

  std::vector<CalibrationPoint> simulatedPoints(const station::Profile& profile) const override {
    std::mt19937_64 random(static_cast<std::uint64_t>(profile.sim.seed) + sensor_);
    std::normal_distribution<double> noise(0.0, profile.sim.ir_noise_mV / 1000.0);
    std::vector<CalibrationPoint> out;
    for (int distance_mm = 40; distance_mm <= 300; distance_mm += 20) {
      double sum = 0.0, squares = 0.0;
      for (int i = 0; i < readings(); ++i) {
        const double code = sim::irCode(sim::irVolts(distance_mm) + noise(random));
        sum += code;
        squares += code * code;
      }
      const double mean = sum / readings();
      const double variance = std::max(0.0, squares / readings() - mean * mean) * readings() / (readings() - 1.0);
      out.push_back({mean, static_cast<double>(distance_mm), std::sqrt(variance)});
    }
    return out;
  }

 private:
  std::size_t sensor_;
};

}  // namespace

CalibrationSteps irSteps(const station::Profile& profile) {
  CalibrationSteps out;
  const std::size_t sensors = profile.step.sensing.indentation.sensors();
  for (std::size_t i = 0; i < sensors; ++i) {
    out.push_back(std::make_unique<IrStep>(i));
  }
  return out;
}

}  // namespace fyd::console
