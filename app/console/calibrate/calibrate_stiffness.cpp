// The stiffness map's step: the console stretches the cloth, only while the operator holds the button, and a finger
// presses at each stretch.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "app/console/calibrate/calibrate_step.h"
#include "core/calibration/stiffness_map.h"
#include "core/control/static_law.h"
#include "core/sim/cloth/cloth.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {
namespace {

using widgets::tr;

/// Points are: stretch, indentation, force.
class StiffnessStep : public CalibrationStep {
 public:
  explicit StiffnessStep(const control::ControlParameters& control)
      : lowest_deg_(control.travel_minimum_deg), highest_deg_(control.travel_maximum_deg) {}
  void takeProfile(const station::Profile& profile) override {
    lowest_deg_ = profile.step.control.travel_minimum_deg;
    highest_deg_ = profile.step.control.travel_maximum_deg;
  }
  QString id() const override { return QStringLiteral("stiffness"); }
  std::string procedure() const override { return "stiffness"; }
  std::string_view errorLimit() const override { return "calibration.stiffness_held_out_N"; }
  int readings() const override { return 5; }
  int readingColumn() const override { return 1; }
  Motion motion() const override { return Motion::stretch; }
  bool trustsIndentation() const override { return true; }
  /// Its points are depths and forces from the zeros in force, and one fit knows one zero; a depth is that at the place
  /// where the camera sees the finger.
  bool readWith(std::string_view calibration) const override {
    return calibration == "no-touch" || placesTheFinger(calibration) || CalibrationStep::readWith(calibration);
  }
  QString instruction(const std::vector<CalibrationPoint>& points) const override {
    return points.empty() ? tr("Type a stretch and hold the button: the motors go there. Meanwhile press the cloth to "
                               "three depths, each for a second; points are taken by themselves.")
                          : tr("Let go, type the next stretch, hold the button and press to three depths again.");
  }
  QStringList columns() const override { return {tr("Stretch, °"), tr("Indentation, mm"), tr("Force, N")}; }
  std::vector<CalibrationEntry> entries() const override { return {stretchEntry(lowest_deg_, highest_deg_)}; }
  double offer(const std::vector<CalibrationPoint>& points) const override {
    // Ends first: a law is valid only between its points.
    constexpr std::array kShares = {0.0, 1.0, 0.5, 0.25, 0.75};
    const auto angles = anglesOf(points);
    for (const double share : kShares) {
      const double deg = std::round(lowest_deg_ + share * (highest_deg_ - lowest_deg_));
      if (std::ranges::none_of(angles, [&](double angle) { return std::abs(angle - deg) <= kSameStretch_deg; })) {
        return deg;
      }
    }
    return calibration::kUnknown;
  }
  std::vector<CalibrationSignal> signalsWanted(const station::Profile&) const override {
    constexpr double kMoving_mm = 0.3, kMoving_N = 0.2, kMoving_deg = 1.0;
    return {{tr("Indentation"), QStringLiteral("mm"), 2, kMoving_mm},
            {tr("Force"), QStringLiteral("N"), 3, kMoving_N},
            {tr("Stretch"), QStringLiteral("°"), 1, kMoving_deg}};
  }
  Result<std::vector<double>> read(const CalibrationScene& scene) const override {
    const pipeline::TelemetrySample& now = scene.newest;
    if (!std::isfinite(now.stretch_measured_deg)) {
      return fail("the stretch is not known: look under Devices whether the motors answer");
    }
    if (!std::isfinite(now.indentation_mm)) return fail("no indentation is measured: press the cloth with a finger");
    if (!std::isfinite(now.force_N)) return fail("no force is measured: look at the load cell's cable");
    return std::vector{now.indentation_mm, now.force_N, now.stretch_measured_deg};
  }
  QString notYet(const CalibrationScene& scene, const std::vector<CalibrationPoint>& points,
                 const std::vector<double>& mean) const override {
    if (!scene.motion.resting) return tr("The motors are on their way.");
    if (mean[0] < calibration::kLeastPress_mm) return tr("Press the cloth now, and hold the depth for a second.");
    const bool taken = std::ranges::any_of(points, [&](const CalibrationPoint& point) {
      return std::abs(point[0] - mean[2]) <= kSameStretch_deg && std::abs(point[1] - mean[0]) < kSameDepth_mm;
    });
    if (taken) return tr("This depth is taken: press deeper or less deep, then let go and go on to the next stretch.");
    return {};
  }
  CalibrationPoint point(const std::vector<double>&, const std::vector<double>& mean,
                         const std::vector<double>&) const override {
    return {mean[2], mean[0], mean[1]};
  }

  CalibrationFit fit(const std::vector<CalibrationPoint>& points, const station::Profile& profile) const override {
    const auto& p = profile.calibration;
    if (points.empty()) {
      return noPoints(
          tr("%1 presses of different depth at %2 or more stretches, the least and the greatest among them.")
              .arg(p.stiffness_fewest_presses)
              .arg(p.stiffness_fewest_angles));
    }
    const auto found = calibration::calibrateStiffness(
        {.angle_deg = columnOf(points, 0), .indentation_mm = columnOf(points, 1), .force_N = columnOf(points, 2)}, p);
    CalibrationFit out{.result = found.result, .plot = {}, .legend = {}, .missing = missingOf(found.result)};
    out.legend =
        tr("Dots: each press. Bars: an angle's stiffness with its 95 % interval. Line: the new law. Dashed: "
           "the one in force. Crosses: presses the others contradict.");
    out.plot = {.x_title = tr("Stretch, °"), .y_title = tr("Stiffness, N/mm"), .residual_title = tr("Residual, N")};
    const double offset_N = std::isfinite(found.force_offset_N) ? found.force_offset_N : 0.0;
    for (const CalibrationPoint& point : points) {
      out.plot.points.emplace_back(point[0], (point[2] - offset_N) / std::max(point[1], 0.1));
    }
    out.plot.residuals = found.result.residuals;
    out.plot.outliers = found.result.outliers;
    for (const calibration::AngleStiffness& angle : found.angles) {
      out.plot.bars.push_back({angle.angle_deg, angle.low_95, angle.high_95});
    }
    ParameterList angles, levels;
    for (const double deg : found.law_angle_deg) (void)angles.push(deg);
    for (const double level : found.law_stiffness_N_per_mm) (void)levels.push(level);
    control::StaticLaw law;
    const bool fitted =
        found.result.verdict.accepted && law.configure(control::StaticLawKind::interpolated, angles, levels);
    if (fitted) out.plot.curve = drawn(law);
    out.plot.former_curve = drawn(control::StaticLaw(profile.step.control));
    if (std::isfinite(found.force_offset_N)) {
      out.figures << tr("a wrong tare of %1 ± %2 is taken into account")
                         .arg(widgets::numberText(found.force_offset_N, 3),
                              widgets::quantityText(found.force_offset_error_N, 3, QStringLiteral("N")));
    }
    if (fitted) out.figures << tr("the law is rising; beyond its ends the controller stays at them");
    return out;
  }

  std::vector<CalibrationPoint> simulatedPoints(const station::Profile& profile) const override {
    constexpr double kDepthNoise_mm = 0.1, kForceNoise_N = 0.01;  // of half a second's mean
    std::mt19937_64 random(static_cast<std::uint64_t>(profile.sim.seed));
    std::normal_distribution<double> noise;
    const sim::Cloth cloth(profile.sim);
    std::vector<CalibrationPoint> out;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double deg = lowest_deg_ + share * (highest_deg_ - lowest_deg_);
      for (const double depth_mm : {2.0, 4.0, 6.0, 8.0}) {
        const sim::FingerState finger{.indentation_mm = depth_mm, .lifted = false};
        const double force_N = cloth.stiffness(deg, finger) * depth_mm + kForceNoise_N * noise(random);
        out.push_back({deg, depth_mm + kDepthNoise_mm * noise(random), force_N});
      }
    }
    return out;
  }

 private:
  static constexpr double kSameStretch_deg = 2.0;
  static constexpr double kSameDepth_mm = 1.0;

  static std::vector<double> anglesOf(const std::vector<CalibrationPoint>& points) { return columnOf(points, 0); }
  static std::vector<QPointF> drawn(const control::StaticLaw& law) {
    constexpr int kPoints = 60;
    std::vector<QPointF> out;
    const double from = law.minimumAngle_deg(), to = law.maximumAngle_deg();
    for (int i = 0; i <= kPoints; ++i) {
      const double deg = from + (to - from) * i / kPoints;
      out.emplace_back(deg, law.stiffness_N_per_mm(deg).value);
    }
    return out;
  }

  double lowest_deg_;
  double highest_deg_;
};

}  // namespace

CalibrationSteps stiffnessSteps(const station::Profile& profile) {
  return oneStep<StiffnessStep>(profile.step.control);
}

}  // namespace fyd::console
