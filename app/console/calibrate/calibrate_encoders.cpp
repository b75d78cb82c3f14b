// The encoders' step: the console sends the motors along a sweep, only while the operator holds the button.
#include <algorithm>
#include <cmath>
#include <random>

#include "app/console/calibrate/calibrate_step.h"
#include "core/calibration/encoder_calibration.h"
#include "core/device/touchpad/test_motion.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {
namespace {

using widgets::tr;

constexpr double kTurn_counts = control::kEncoderCountsPerTurn;

/// Points are: first angle commanded, first encoder, second angle commanded, second encoder.
class EncoderStep : public CalibrationStep {
 public:
  QString id() const override { return QStringLiteral("encoders"); }
  std::string procedure() const override { return "encoders"; }
  std::string_view errorLimit() const override { return "calibration.encoder_held_out_deg"; }
  int readings() const override { return 2; }  // two, so that a motor on its way to where it was sent is seen to move
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
    return {{tr("Encoder 1"), tr("counts"), 0, kMoving_counts, kTurn_counts},
            {tr("Encoder 2"), tr("counts"), 0, kMoving_counts, kTurn_counts}};
  }
  Result<std::vector<double>> read(const CalibrationScene& scene) const override {
    std::vector<double> out;
    for (const std::size_t motor : {std::size_t{1}, std::size_t{2}}) {
      const auto counts = liveValue(scene.devices, say("encoder {}", motor));
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
      return noPoints(tr("One sweep of at least %1° with 5 angles.")
                          .arg(widgets::plainNumber(profile.calibration.encoder_least_sweep_deg)));
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

}  // namespace

CalibrationSteps encoderSteps(const station::Profile&) { return oneStep<EncoderStep>(); }

}  // namespace fyd::console
