// The step that checks the robot's accelerometer at rest for plausibility. It changes no value.
#include <array>
#include <cmath>
#include <random>

#include "app/console/calibrate/calibrate_step.h"
#include "core/calibration/rest_calibration.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {
namespace {

using widgets::tr;

constexpr std::size_t kAxes = 3;

/// The one point is x, y, z of each reading, one after the other.
calibration::RestSamples samplesOf(const CalibrationPoint& point) {
  calibration::RestSamples out;
  for (std::size_t i = 0; i + kAxes <= point.size(); i += kAxes) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) out.axis_g[axis].push_back(point[i + axis]);
  }
  return out;
}

class RestStep : public CalibrationStep {
 public:
  QString id() const override { return QStringLiteral("rest"); }
  std::string procedure() const override { return "rest"; }
  bool onePoint() const override { return true; }
  int readings() const override { return 150; }
  int interval_ms() const override { return 20; }
  int readingColumn() const override { return -1; }
  QString instruction(const std::vector<CalibrationPoint>& points) const override {
    return points.empty() ? tr("Put the robot to rest with its tool in the air, and take the point: it lasts 3 s.")
                          : tr("Look at the figures at the right, then accept them or measure again.");
  }
  QStringList columns() const override { return {tr("x, g"), tr("y, g"), tr("z, g"), tr("Length, g")}; }
  QStringList row(const CalibrationPoint& point) const override {
    QStringList out;
    double squares = 0.0;
    for (const std::vector<double>& axis : samplesOf(point).axis_g) {
      double mean = 0.0;
      for (const double value : axis) mean += value / static_cast<double>(axis.size());
      out << widgets::numberText(mean, 4);
      squares += mean * mean;
    }
    return out << widgets::numberText(std::sqrt(squares), 4);
  }
  std::vector<CalibrationSignal> signalsWanted(const station::Profile& profile) const override {
    const double moving_g = profile.calibration.rest_sigma_g;
    return {{QStringLiteral("x"), QStringLiteral("g"), 3, moving_g},
            {QStringLiteral("y"), QStringLiteral("g"), 3, moving_g},
            {QStringLiteral("z"), QStringLiteral("g"), 3, moving_g}};
  }
  Result<std::vector<double>> read(const CalibrationScene& scene) const override {
    const pipeline::TelemetrySample& now = scene.newest;
    std::vector<double> out = {now.acceleration_x_g, now.acceleration_y_g, now.acceleration_z_g};
    for (const double value : out) {
      if (!std::isfinite(value)) return fail("the robot sends no acceleration: look at the link's panel");
    }
    return out;
  }
  CalibrationPoint point(const std::vector<double>&, const std::vector<double>& mean,
                         const std::vector<double>&) const override {
    return mean;
  }
  CalibrationPoint pointOf(const std::vector<std::vector<double>>& readings) const override {
    CalibrationPoint out;
    for (const std::vector<double>& reading : readings) out.insert(out.end(), reading.begin(), reading.end());
    return out;
  }

  CalibrationFit fit(const std::vector<CalibrationPoint>& points, const station::Profile& profile) const override {
    if (points.empty()) return noPoints(tr("One measurement of 3 s."));
    const auto samples = samplesOf(points.back());
    const auto found = calibration::calibrateRest(samples, profile.calibration);
    CalibrationFit out{.result = found.result, .plot = {}, .legend = {}, .missing = missingOf(found.result)};
    out.legend = tr("Dots: length of each reading. Line: their mean. Dashed: what is expected.");
    out.plot = {.x_title = tr("Reading"), .y_title = tr("Length, g"), .residual_title = tr("From the mean, g")};
    const std::size_t count = samples.axis_g[0].size();
    for (std::size_t i = 0; i < count; ++i) {
      out.plot.points.emplace_back(static_cast<double>(i + 1),
                                   std::hypot(samples.axis_g[0][i], samples.axis_g[1][i], samples.axis_g[2][i]));
    }
    out.plot.residuals = found.result.residuals;
    const auto last = static_cast<double>(count);
    out.plot.curve = {{1.0, found.magnitude_g}, {last, found.magnitude_g}};
    const double expected_g = found.magnitude_g < 0.5 ? 0.0 : 1.0;  // 0: the robot end subtracts gravity
    out.plot.former_curve = {{1.0, expected_g}, {last, expected_g}};
    out.figures << tr("spread x %1, y %2, z %3")
                       .arg(widgets::numberText(found.sigma_g[0], 4), widgets::numberText(found.sigma_g[1], 4),
                            widgets::quantityText(found.sigma_g[2], 4, QStringLiteral("g")))
                << tr("no value changes: the texture takes rest away by itself");
    return out;
  }

  std::vector<CalibrationPoint> simulatedPoints(const station::Profile& profile) const override {
    std::mt19937_64 random(static_cast<std::uint64_t>(profile.sim.seed));
    std::normal_distribution<double> noise(0.0, profile.sim.accelerometer_noise_g);
    CalibrationPoint out;
    for (int i = 0; i < readings(); ++i) {
      for (const double rest_g : {0.0, 0.0, 1.0}) out.push_back(rest_g + noise(random));
    }
    return {out};
  }
};

}  // namespace

CalibrationSteps restSteps(const station::Profile&) { return oneStep<RestStep>(); }

}  // namespace fyd::console
