// Steps for which the console drives the motors, only while the operator holds the button: the encoders along a sweep,
// and the stiffness map, for which a finger presses at each stretch.
#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "app/console/calibrate_step.h"
#include "core/calibration/encoder_calibration.h"
#include "core/calibration/stiffness_map.h"
#include "core/control/static_law.h"
#include "core/device/test_motion.h"
#include "core/sim/fabric.h"
#include "widgets/number_text.h"

namespace fyd::console {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("CalibrationStep", text); }

constexpr double kTurn_counts = control::kEncoderCountsPerTurn;

/// Points are: first angle commanded, first encoder, second angle commanded, second encoder.
class EncoderStep : public CalibrationStep {
 public:
  QString id() const override { return QStringLiteral("encoders"); }
  QString name() const override { return tr("Encoders: sign, zero, range"); }
  std::string procedure() const override { return "encoders"; }
  int readings() const override { return 1; }
  int readingColumn() const override { return 1; }
  Motion motion() const override { return Motion::sweep; }
  QString instruction(const std::vector<CalibrationPoint>& points) const override {
    return points.empty() ? tr("Take your hands off the cloth and hold the button for 16 s: both motors go to their "
                               "zero at once, then by steps of %1° to %2° and back.")
                                .arg(device::kSweepStep_deg)
                                .arg(device::kSweepTop_deg)
                          : tr("Hold the button until the sweep is done, then look at the fit and accept it.");
  }
  QStringList columns() const override {
    return {tr("Motor 1, °"), tr("Encoder 1"), tr("Motor 2, °"), tr("Encoder 2")};
  }
  QStringList row(const CalibrationPoint& point) const override {
    return {widgets::numberText(point[0], 1), widgets::numberText(point[1], 0), widgets::numberText(point[2], 1),
            widgets::numberText(point[3], 0)};
  }
  std::vector<CalibrationSignal> signalsWanted(const station::Profile&) const override {
    constexpr double kMoving_counts = 12.0;  // 1°
    return {{tr("Encoder 1"), tr("counts"), 0, kMoving_counts}, {tr("Encoder 2"), tr("counts"), 0, kMoving_counts}};
  }
  Result<std::vector<double>> read(const CalibrationScene& scene) const override {
    std::vector<double> out;
    for (const char* name : {"encoder 1", "encoder 2"}) {
      const auto counts = liveValue(scene.devices, name);
      if (!counts) return tl::unexpected(counts.error());
      out.push_back(*counts);
    }
    out.insert(out.end(), scene.motion.commanded_deg.begin(), scene.motion.commanded_deg.end());
    return out;
  }
  QString notYet(const CalibrationScene& scene, const std::vector<CalibrationPoint>& points,
                 const std::vector<double>& mean) const override {
    if (!scene.motion.resting) return tr("The motors are on their way.");
    if (!points.empty() && points.back()[0] == mean[2]) return tr("This angle is taken.");
    return {};
  }
  CalibrationPoint point(const std::vector<double>&, const std::vector<double>& mean,
                         const std::vector<double>&) const override {
    return {mean[2], mean[0], mean[3], mean[1]};
  }

  CalibrationFit fit(const std::vector<CalibrationPoint>& points, const station::Profile& profile) const override {
    if (points.empty()) {
      return noPoints(tr("One sweep of at least %1° with 5 angles.").arg(profile.calibration.encoder_least_sweep_deg));
    }
    const auto found = calibration::calibrateEncoders({.command_deg = {columnOf(points, 0), columnOf(points, 2)},
                                                       .counts = {columnOf(points, 1), columnOf(points, 3)}},
                                                      profile.calibration);
    CalibrationFit out{.result = found.result, .plot = {}, .legend = {}, .missing = missingOf(found.result)};
    out.legend =
        tr("Dots: both encoders with the new zero and sign. Line: where the motors were sent. Dashed: the "
           "first encoder as it is read now.");
    out.plot = {.x_title = tr("Commanded, °"), .y_title = tr("Measured, °"), .residual_title = tr("Residual, °")};
    const auto& control = profile.step.control;
    double low = 0.0, high = 0.0;
    for (std::size_t motor = 0; motor < control::kMotorCount; ++motor) {
      const calibration::EncoderFinding& encoder = found.encoders[motor];
      const double scale = (encoder.inverted ? -1.0 : 1.0) * control::kEncoderCountsPerDegree;
      for (const CalibrationPoint& point : points) {
        const double counts = std::remainder(point[2 * motor + 1] - encoder.zero_counts, kTurn_counts);
        out.plot.points.emplace_back(point[2 * motor], counts / scale);
        low = std::min(low, point[2 * motor]);
        high = std::max(high, point[2 * motor]);
      }
      out.figures << tr("encoder %1: %2, zero at %3 counts, swept from %4 to %5")
                         .arg(motor + 1)
                         .arg(encoder.inverted ? tr("counts against its motor") : tr("counts with its motor"))
                         .arg(encoder.zero_counts)
                         .arg(widgets::numberText(encoder.from_deg, 1),
                              widgets::quantityText(encoder.to_deg, 1, QStringLiteral("°")));
    }
    out.plot.residuals = found.result.residuals;
    out.plot.curve = {{low, low}, {high, high}};
    const double former_scale = (control.encoder_first_inverted ? -1.0 : 1.0) * control::kEncoderCountsPerDegree;
    for (const CalibrationPoint& point : points) {
      const double counts = std::remainder(point[1] - control.encoder_zero_first_counts, kTurn_counts);
      out.plot.former_curve.emplace_back(point[0], counts / former_scale);
    }
    std::ranges::sort(out.plot.former_curve, {}, &QPointF::x);
    return out;
  }

  std::vector<CalibrationPoint> simulatedPoints(const station::Profile& profile) const override {
    std::mt19937_64 random(static_cast<std::uint64_t>(profile.sim.seed));
    std::normal_distribution<double> play(0.0, 0.5);  // counts: the simulated gear has hardly any
    const auto counts = [&](double deg) {
      const double at = std::round(deg * control::kEncoderCountsPerDegree + play(random));
      return at - kTurn_counts * std::floor(at / kTurn_counts);
    };
    std::vector<CalibrationPoint> out;
    const int levels = static_cast<int>(2.0 * device::kSweepTop_deg / device::kSweepStep_deg);
    for (int i = 0; i <= levels; ++i) {
      const double deg = device::kSweepTop_deg - std::abs(device::kSweepTop_deg - i * device::kSweepStep_deg);
      const double first = counts(deg), second = counts(-deg);
      out.push_back({deg, first, -deg, second});
    }
    return out;
  }
};

/// Points are: stretch, indentation, force.
class StiffnessStep : public CalibrationStep {
 public:
  explicit StiffnessStep(const control::ControlParameters& control)
      : lowest_deg_(control.travel_minimum_deg), highest_deg_(control.travel_maximum_deg) {}
  QString id() const override { return QStringLiteral("stiffness"); }
  QString name() const override { return tr("Stiffness map"); }
  std::string procedure() const override { return "stiffness"; }
  int readings() const override { return 5; }
  int readingColumn() const override { return 1; }
  Motion motion() const override { return Motion::stretch; }
  QString instruction(const std::vector<CalibrationPoint>& points) const override {
    return points.empty() ? tr("Type a stretch and hold the button: the motors go there. Meanwhile press the cloth to "
                               "three depths, each for a second; points are taken by themselves.")
                          : tr("Let go, type the next stretch, hold the button and press to three depths again.");
  }
  QStringList columns() const override { return {tr("Stretch, °"), tr("Indentation, mm"), tr("Force, N")}; }
  std::vector<CalibrationEntry> entries() const override {
    return {{.name = tr("Stretch"),
             .units = {QStringLiteral("°")},
             .per_unit = {1.0},
             .lowest = lowest_deg_,
             .highest = highest_deg_,
             .decimals = 1}};
  }
  double offer(const std::vector<CalibrationPoint>& points) const override {
    // Ends first: a law reaches no further than its points.
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
    const sim::Fabric cloth(profile.sim.fabric_stiffness_scale, 0.0);
    std::vector<CalibrationPoint> out;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double deg = lowest_deg_ + share * (highest_deg_ - lowest_deg_);
      for (const double depth_mm : {2.0, 4.0, 6.0, 8.0}) {
        const double force_N = cloth.stiffness(deg) * depth_mm + kForceNoise_N * noise(random);
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

std::unique_ptr<CalibrationStep> makeEncoderStep() { return std::make_unique<EncoderStep>(); }
std::unique_ptr<CalibrationStep> makeStiffnessStep(const control::ControlParameters& parameters) {
  return std::make_unique<StiffnessStep>(parameters);
}

}  // namespace fyd::console
