// The step that identifies the dynamics from motor duty to finger: the duty at which the motors break away, and the
// resonance of the cloth under a finger. Each press of the button is one experiment, recorded by the haptic loop at
// 1 kHz.
#include <algorithm>
#include <cmath>

#include "app/console/calibrate/calibrate_step.h"
#include "core/calibration/texture_calibration.h"
#include "core/sim/touchpad/vibration_sweep.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {
namespace {

using widgets::tr;

/// A point is a whole experiment: its stretch, then for each millisecond the values of a SweepRow without the stretch.
constexpr std::size_t kRowFigures = 7;

CalibrationPoint pointOfSweep(const std::vector<texture::SweepRow>& rows) {
  CalibrationPoint out{rows.front().stretch_deg};
  for (const texture::SweepRow& row : rows) {
    out.insert(out.end(), {row.t_s, static_cast<double>(row.part), row.duty_percent[0], row.duty_percent[1],
                           static_cast<double>(row.encoder_counts[0]), static_cast<double>(row.encoder_counts[1]),
                           row.acceleration_g});
  }
  return out;
}

/// Whether it is a breakaway experiment, in which never both motors have a duty at once.
bool isRamps(const CalibrationPoint& point) {
  for (std::size_t i = 1; i + kRowFigures <= point.size(); i += kRowFigures) {
    if (point[i + 2] * point[i + 3] != 0.0) return false;
  }
  return true;
}

/// All points as one sweep; the experiments of all points get different numbers.
std::vector<texture::SweepRow> sweepOf(const std::vector<CalibrationPoint>& points) {
  std::vector<texture::SweepRow> out;
  int before = 0;
  for (const CalibrationPoint& point : points) {
    int last = before;
    for (std::size_t i = 1; i + kRowFigures <= point.size(); i += kRowFigures) {
      const double* row = &point[i];
      last = before + static_cast<int>(row[1]);
      out.push_back({.t_s = row[0],
                     .part = last,
                     .stretch_deg = point[0],
                     .duty_percent = {row[2], row[3]},
                     .encoder_counts = {static_cast<int>(row[4]), static_cast<int>(row[5])},
                     .acceleration_g = row[6]});
    }
    before = last;
  }
  return out;
}

class TextureStep : public CalibrationStep {
 public:
  explicit TextureStep(const station::Profile& profile)
      : lowest_deg_(profile.step.control.travel_minimum_deg), highest_deg_(profile.step.control.travel_maximum_deg) {}
  void takeProfile(const station::Profile& profile) override {
    lowest_deg_ = profile.step.control.travel_minimum_deg;
    highest_deg_ = profile.step.control.travel_maximum_deg;
  }
  QString id() const override { return QStringLiteral("texture"); }
  std::string procedure() const override { return "texture"; }
  int readings() const override { return 1; }
  int readingColumn() const override { return -1; }
  Motion motion() const override { return Motion::experiment; }
  device::DeviceTest test(const std::vector<CalibrationPoint>& points) const override {
    return std::ranges::any_of(points, isRamps) ? device::DeviceTest::chirp : device::DeviceTest::breakaway;
  }
  QString instruction(const std::vector<CalibrationPoint>& points) const override {
    if (test(points) == device::DeviceTest::breakaway) {
      return tr("Take your hands off the cloth and hold the button for %1 s: the duty of each motor grows until it "
                "turns.")
          .arg(widgets::numberText(std::ceil(breakaway_s()), 0));
    }
    if (points.size() < 3) {
      return tr("Lay the robot's accelerometer on the cloth, along its motion, and a finger beside it. Then hold the "
                "button until the sweep of %1 s is over: at two stretches or more.")
          .arg(widgets::numberText(device::kChirp_s, 0));
    }
    return tr("Look at the verdict at the right, then accept it, or add a sweep at another stretch.");
  }
  QStringList columns() const override { return {tr("Experiment"), tr("Stretch, °")}; }
  QStringList row(const CalibrationPoint& point) const override {
    return {isRamps(point) ? tr("breakaway") : tr("sweep"), widgets::numberText(point[0], 1)};
  }
  std::vector<CalibrationEntry> entries() const override { return {stretchEntry(lowest_deg_, highest_deg_)}; }
  double offer(const std::vector<CalibrationPoint>& points) const override {
    constexpr double kApart_deg = 5.0;
    for (const double share : {0.15, 0.85, 0.5}) {
      const double deg = std::round(lowest_deg_ + share * (highest_deg_ - lowest_deg_));
      if (std::ranges::none_of(points, [&](const CalibrationPoint& point) {
            return !isRamps(point) && std::abs(point[0] - deg) < kApart_deg;
          })) {
        return deg;
      }
    }
    return calibration::kUnknown;
  }
  std::vector<CalibrationSignal> signalsWanted(const station::Profile&) const override {
    constexpr double kAny = 1e9;  // movement is wanted here
    return {{tr("Acceleration, x"), QStringLiteral("g"), 2, kAny},
            {tr("Acceleration, y"), QStringLiteral("g"), 2, kAny},
            {tr("Acceleration, z"), QStringLiteral("g"), 2, kAny}};
  }
  Result<std::vector<double>> read(const CalibrationScene& scene) const override {
    const pipeline::TelemetrySample& now = scene.newest;
    return std::vector{now.acceleration_x_g, now.acceleration_y_g, now.acceleration_z_g};
  }
  CalibrationPoint pointOfExperiment(const std::vector<texture::SweepRow>& sweep) const override {
    return sweep.empty() ? CalibrationPoint{} : pointOfSweep(sweep);
  }

  CalibrationFit fit(const std::vector<CalibrationPoint>& points, const station::Profile& profile) const override {
    if (points.empty()) {
      return noPoints(
          tr("The breakaway of both motors, and sweeps at two stretches, 10° apart, with an accelerometer."));
    }
    CalibrationFit out;
    out.legend =
        tr("Dots: the resonance at each stretch, with its uncertainty. Line: what the texture will reckon with. "
           "Dashed: what it reckons with now.");
    out.plot = {.x_title = tr("Stretch, °"), .y_title = tr("Resonance, Hz"), .residual_title = tr("Residual, Hz")};
    if (std::ranges::none_of(points, isRamps) || points.size() < 3) {
      out.missing = std::ranges::any_of(points, isRamps)
                        ? tr("Sweeps at two stretches, 10° apart, with an accelerometer.")
                        : tr("The breakaway of both motors.");
      out.result.procedure = procedure();
      out.result.verdict = {.too_few = true, .reason = say("not enough experiments yet")};
      return out;
    }
    const texture::FeltPlant& former = profile.step.texture.plant;
    const auto found = calibration::calibrateTexture(sweepOf(points), former);
    out.result = found.result;
    if (!found.result.verdict.accepted) return out;
    const texture::FeltPlant& plant = found.identified.plant;
    for (const texture::FoundCloth& cloth : found.identified.cloths) {
      out.plot.points.emplace_back(cloth.stretch_deg, cloth.resonance_Hz);
      out.plot.bars.push_back(
          {cloth.stretch_deg, cloth.resonance_Hz - 2.0 * cloth.sigma_Hz, cloth.resonance_Hz + 2.0 * cloth.sigma_Hz});
      out.figures << tr("at %1: %2, damping %3, %4 % left")
                         .arg(widgets::quantityText(cloth.stretch_deg, 0, QStringLiteral("°")),
                              widgets::quantityText(cloth.resonance_Hz, 1, QStringLiteral("Hz")),
                              widgets::numberText(cloth.damping, 2),
                              widgets::numberText(100.0 * cloth.held_out_error, 0));
    }
    out.plot.residuals = found.result.residuals;
    for (const double deg : {lowest_deg_, highest_deg_}) {
      out.plot.curve.emplace_back(deg, plant.resonanceAt_Hz(deg));
      out.plot.former_curve.emplace_back(deg, former.resonanceAt_Hz(deg));
    }
    out.figures << tr("a turning motor has %1 % of its breakaway")
                       .arg(widgets::numberText(100.0 * found.identified.sliding_share, 0));
    return out;
  }

  std::vector<CalibrationPoint> simulatedPoints(const station::Profile& profile) const override {
    std::vector<CalibrationPoint> out;
    out.push_back(simulated(profile, device::DeviceTest::breakaway, lowest_deg_));
    for (int i = 0; i < 2; ++i) out.push_back(simulated(profile, device::DeviceTest::chirp, offer(out)));
    return out;
  }

 private:
  static CalibrationPoint simulated(const station::Profile& profile, device::DeviceTest test, double stretch_deg) {
    return pointOfSweep(
        sim::simulatedSweep(profile.sim.vibration, test, stretch_deg, static_cast<std::uint64_t>(profile.sim.seed)));
  }

  double breakaway_s() const {
    const auto motion = device::TestMotion::plan(device::DeviceTest::breakaway, {}, highest_deg_);
    return motion ? toSeconds(motion->length()) : 0.0;
  }

  double lowest_deg_;
  double highest_deg_;
};

}  // namespace

CalibrationSteps textureSteps(const station::Profile& profile) { return oneStep<TextureStep>(profile); }

}  // namespace fyd::console
