// The step that measures the cloth's deflection beside a press: a finger presses over each distance sensor at two
// depths, and each press is held until its mean is good enough.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "app/console/calibrate/calibrate_step.h"
#include "core/calibration/cloth_calibration.h"
#include "core/sensing/contact_cloth.h"
#include "core/sensing/ir_distance.h"
#include "core/sim/touchpad/cloth_presses.h"
#include "core/sim/touchpad/ir_sensor.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {
namespace {

using widgets::tr;

constexpr double kOld_ms = 500.0;

/// Points are: a code of each sensor, then the contact on the cloth (perspective removed) and the bridge. How deep a
/// press is follows from the codes, by the curves and offsets in force.
enum Place : std::size_t { kX, kY, kArea, kBridge, kAfterCodes };

double after(const CalibrationPoint& point, Place place) { return point[point.size() - kAfterCodes + place]; }

struct Nearest {
  std::size_t sensor = 0;
  double beside_mm = std::numeric_limits<double>::infinity();
};
Nearest nearestTo(double x_mm, double y_mm, const sensing::IndentationParameters& p) {
  Nearest out;
  for (std::size_t i = 0; i < p.sensors(); ++i) {
    const double away = std::hypot(x_mm - p.ir_x_mm[i], y_mm - p.ir_y_mm[i]);
    if (away < out.beside_mm) out = {i, away};
  }
  return out;
}

/// Deflection of the cloth at a sensor, mm; NaN: no valid reading.
double dropOf(const sensing::IndentationParameters& p, std::size_t sensor, double code) {
  const sensing::IrReading read = distanceSensorOf(p, sensor).read(code);
  return read.valid && sensor < p.ir_offset_mm.size() ? p.ir_offset_mm[sensor] - read.distance_mm
                                                      : calibration::kUnknown;
}

/// How deep the press is at the sensor under the finger, mm; NaN: it does not read.
double depthOf(const CalibrationPoint& point, const sensing::IndentationParameters& p) {
  const std::size_t sensor = nearestTo(after(point, kX), after(point, kY), p).sensor;
  return sensor + kAfterCodes < point.size() ? dropOf(p, sensor, point[sensor]) : calibration::kUnknown;
}

/// @param codes one per sensor; @param seen as the camera sees it
CalibrationPoint pointOnTheCloth(std::vector<double> codes, const sensing::Contact& seen, double bridge_mV_per_V,
                                 const sensing::IndentationParameters& p) {
  sensing::Contact contact = seen;
  // The depth moves the contact by a few per cent of its distance from the middle: the sensor stays the nearest.
  for (int round = 0; round < 2; ++round) {
    const std::size_t sensor = nearestTo(contact.x_mm, contact.y_mm, p).sensor;
    const double depth_mm = dropOf(p, sensor, codes[sensor]);
    if (std::isfinite(depth_mm)) contact = sensing::withoutPerspective(seen, depth_mm, p.camera_height_mm);
  }
  codes.insert(codes.end(), {contact.x_mm, contact.y_mm, contact.area_mm2, bridge_mV_per_V});
  return codes;
}

class ClothStep : public CalibrationStep {
 public:
  explicit ClothStep(const station::Profile& profile)
      : indentation_(profile.step.sensing.indentation), limits_(profile.calibration) {}
  void takeProfile(const station::Profile& profile) override {
    indentation_ = profile.step.sensing.indentation;
    limits_ = profile.calibration;
  }
  QString id() const override { return QStringLiteral("cloth"); }
  std::string procedure() const override { return "cloth"; }
  std::string_view errorLimit() const override { return "calibration.cloth_held_out_mm"; }
  int interval_ms() const override { return kDistanceInterval_ms; }
  int readings() const override { return distanceReadings(indentation_); }
  int readingColumn() const override { return -1; }
  /// Beside the sensors' codes its points have the contact as the camera saw it.
  bool readWith(std::string_view calibration) const override {
    return placesTheFinger(calibration) || CalibrationStep::readWith(calibration);
  }
  QString instruction(const std::vector<CalibrationPoint>& points) const override {
    const QString next = nextPress(points);
    if (next.isEmpty()) return tr("Look at the verdict at the right, then accept it, or add presses.");
    return tr("%1 Hold still, take the point, and hold on until the bar is full: %2 s.")
        .arg(next)
        .arg(std::lround(readings() * interval_ms() / 1000.0));
  }
  QStringList columns() const override {
    return {tr("Sensor"), tr("Depth there, mm"), tr("Beside, mm"), tr("Area, mm²"), tr("Bridge, mV/V")};
  }
  QStringList row(const CalibrationPoint& point) const override {
    const Nearest nearest = nearestTo(after(point, kX), after(point, kY), indentation_);
    return {QString::number(nearest.sensor + 1), widgets::numberText(depthOf(point, indentation_), 2),
            widgets::numberText(nearest.beside_mm, 1), widgets::numberText(after(point, kArea), 1),
            widgets::numberText(after(point, kBridge), 3)};
  }
  std::vector<CalibrationSignal> signalsWanted(const station::Profile& profile) const override {
    constexpr double kMoving_counts = 40.0, kMoving_mm = 0.7, kMoving_mm2 = 15.0;
    std::vector<CalibrationSignal> out;
    out.reserve(profile.step.sensing.indentation.sensors());
    for (std::size_t i = 0; i < profile.step.sensing.indentation.sensors(); ++i) {
      out.push_back({tr("Distance %1").arg(i + 1), tr("counts"), 0, kMoving_counts});
    }
    out.push_back({tr("Finger, x"), QStringLiteral("mm"), 1, kMoving_mm});
    out.push_back({tr("Finger, y"), QStringLiteral("mm"), 1, kMoving_mm});
    out.push_back({tr("Finger's area"), QStringLiteral("mm²"), 1, kMoving_mm2});
    return out;
  }
  Result<std::vector<double>> read(const CalibrationScene& scene) const override {
    const auto& p = scene.profile.step.sensing.indentation;
    const sensing::FingerDetection& finger = scene.finger;
    if (scene.newest.finger_age_ms > kOld_ms || !sensing::showsCloth(finger.reason)) {
      return fail("the camera shows no cloth: look under Devices whether it answers");
    }
    if (!finger.contact) return fail("the camera sees no finger: press the cloth over a distance sensor");
    if (p.sensors() == 0) return fail("the profile names no distance sensor: see sensing.ir_x_mm");
    std::vector<double> codes;
    for (std::size_t i = 0; i < p.sensors(); ++i) {
      const auto code = liveValue(scene.devices, say("IR sensor {}", i + 1));
      if (!code) return tl::unexpected(code.error());
      codes.push_back(*code);
    }
    const auto bridge = liveValue(scene.devices, say("load cell"));
    CalibrationPoint out = pointOnTheCloth(codes, {finger.x_mm, finger.y_mm, finger.area_mm2},
                                           bridge ? *bridge : calibration::kUnknown, p);
    const Nearest nearest = nearestTo(after(out, kX), after(out, kY), p);
    const double allowed_mm = scene.profile.calibration.cloth_beside_mm;
    if (!(nearest.beside_mm <= allowed_mm)) {
      return fail(
          "the finger is {:.1f} mm beside distance sensor {}, at most {:g} mm count: move it to {:.0f}, {:.0f} mm",
          nearest.beside_mm, nearest.sensor + 1, allowed_mm, p.ir_x_mm[nearest.sensor], p.ir_y_mm[nearest.sensor]);
    }
    if (!std::isfinite(depthOf(out, p)))
      return fail("distance sensor {} does not read: look under Devices", nearest.sensor + 1);
    return out;
  }
  CalibrationPoint point(const std::vector<double>&, const std::vector<double>& mean,
                         const std::vector<double>&) const override {
    return mean;
  }

  CalibrationFit fit(const std::vector<CalibrationPoint>& points, const station::Profile& profile) const override {
    if (points.empty()) {
      return noPoints(tr("Two presses over each distance sensor, one at least %1 times as deep as the other.")
                          .arg(widgets::numberText(profile.calibration.cloth_depth_ratio, 1)));
    }
    const auto& p = profile.step.sensing.indentation;
    calibration::ClothSamples samples;
    for (const CalibrationPoint& point : points) {
      samples.codes.emplace_back(point.begin(), point.end() - kAfterCodes);
      samples.x_mm.push_back(after(point, kX));
      samples.y_mm.push_back(after(point, kY));
      samples.area_mm2.push_back(after(point, kArea));
    }
    const auto found = calibration::calibrateCloth(samples, p, profile.calibration);
    CalibrationFit out{.result = found.result, .plot = {}, .legend = {}, .missing = nextPress(points)};
    out.legend =
        tr("Dots: each press, what the sensors beside the finger read of it. Below, how far the fit is off there.");
    out.plot = {.x_title = tr("Depth at the sensor under the finger, mm"),
                .y_title = tr("Mean of the others, mm"),
                .residual_title = tr("Error beside, mm")};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Nearest nearest = nearestTo(samples.x_mm[i], samples.y_mm[i], p);
      double sum = 0.0;
      int count = 0;
      for (std::size_t sensor = 0; sensor < samples.codes[i].size(); ++sensor) {
        const double drop_mm = dropOf(p, sensor, samples.codes[i][sensor]);
        if (sensor == nearest.sensor || !std::isfinite(drop_mm)) continue;
        sum += drop_mm;
        ++count;
      }
      out.plot.points.emplace_back(depthOf(points[i], p), count > 0 ? sum / count : calibration::kUnknown);
    }
    out.plot.residuals = found.result.residuals;
    if (found.result.coefficients.size() == 2) {
      const auto& share = found.result.coefficients[0];
      const auto& ratio = found.result.coefficients[1];
      out.figures
          << tr("radius share %1 ± %2")
                 .arg(widgets::numberText(share.value, 3), widgets::numberText(share.standard_error, 3))
          << tr("tension ratio %1 ± %2")
                 .arg(widgets::numberText(ratio.value, 2), widgets::numberText(ratio.standard_error, 2))
          << (found.edges == sensing::ClothEdges::held ? tr("all four edges are held")
                                                       : tr("front and back edges are free"))
          << tr("with the other edges %1").arg(widgets::quantityText(found.other_edges_rmse, 3, QStringLiteral("mm")));
    }
    if (std::isfinite(found.stiffness_error)) {
      out.figures << tr("stiffness known to about %1 %").arg(widgets::numberText(100.0 * found.stiffness_error, 0));
    }
    return out;
  }

  std::vector<CalibrationPoint> simulatedPoints(const station::Profile& profile) const override {
    const auto& p = profile.step.sensing.indentation;
    if (p.sensors() != sim::kIrPlaces.size()) return {};  // the simulation has fixed sensors
    std::mt19937_64 random(static_cast<std::uint64_t>(profile.sim.seed));
    std::normal_distribution<double> noise(0.0, profile.sim.ir_noise_mV / 1000.0);
    std::vector<CalibrationPoint> out;
    constexpr std::array kDepths_mm{3.0, 6.0, 3.0, 6.0, 3.0, 6.0};  // once each is near the limit of acceptance
    for (const sim::ClothPress& press :
         sim::pressesOverSensors(profile.sim, profile.step.control.travel_minimum_deg, kDepths_mm)) {
      std::vector<double> codes;
      for (std::size_t i = 0; i < p.sensors(); ++i) {
        // Sensors that follow the profile exactly: errors of its curves and offsets must not appear as the cloth's.
        const double volts = distanceSensorOf(p, i).voltsAt(p.ir_offset_mm[i] - press.deflection_mm[i]);
        double sum = 0.0;
        for (int k = 0; k < readings(); ++k) sum += sim::irCode(volts + noise(random));
        codes.push_back(sum / readings());
      }
      const double bridge_mV_per_V = calibration::kUnknown;
      out.push_back(
          pointOnTheCloth(codes, {press.seen.x_mm, press.seen.y_mm, press.seen.area_mm2}, bridge_mV_per_V, p));
    }
    return out;
  }

 private:
  /// Which press is missing, in a sentence; empty when all are there.
  QString nextPress(const std::vector<CalibrationPoint>& points) const {
    for (std::size_t sensor = 0; sensor < indentation_.sensors(); ++sensor) {
      double shallowest = std::numeric_limits<double>::infinity(), deepest = 0.0;
      for (const CalibrationPoint& point : points) {
        const double depth_mm = depthOf(point, indentation_);
        if (nearestTo(after(point, kX), after(point, kY), indentation_).sensor != sensor) continue;
        shallowest = std::min(shallowest, depth_mm);
        deepest = std::max(deepest, depth_mm);
      }
      if (deepest == 0.0) return tr("Press over distance sensor %1, some 3 mm deep.").arg(sensor + 1);
      const double wanted = std::max(limits_.cloth_least_depth_mm, limits_.cloth_depth_ratio * shallowest);
      if (deepest < wanted) {
        return tr("Press over distance sensor %1 once more, twice as deep and at least %2.")
            .arg(sensor + 1)
            .arg(widgets::quantityText(std::ceil(10.0 * wanted + 1.0) / 10.0, 1, QStringLiteral("mm")));
      }
    }
    return {};
  }

  sensing::IndentationParameters indentation_;
  calibration::CalibrationParameters limits_;
};

}  // namespace

CalibrationSteps clothSteps(const station::Profile& profile) { return oneStep<ClothStep>(profile); }

}  // namespace fyd::console
