// The step that finds the camera's scale and rotation from the marks of a printed target.
#include <random>

#include "app/console/calibrate/calibrate_step.h"
#include "core/calibration/camera_calibration.h"
#include "core/sim/touchpad/picture.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {
namespace {

using widgets::tr;

class CameraScaleStep : public CalibrationStep {
 public:
  QString id() const override { return QStringLiteral("camera"); }
  std::string procedure() const override { return "camera"; }
  std::string_view errorLimit() const override { return "calibration.camera_held_out_mm"; }
  int readings() const override { return 1; }
  Picture picture() const override { return Picture::place; }
  QString instruction(const std::vector<CalibrationPoint>& points) const override {
    return points.empty() ? tr("Lay the printed target on the cloth, click one of its marks in the picture, type where "
                               "it lies, and take the point.")
                          : tr("Click the next mark, type where it lies, and take the point: best at the cloth's "
                               "corners and in its middle. Marks that you press down, with their depth, tell how high "
                               "the camera is.");
  }
  QStringList columns() const override { return {tr("x, px"), tr("y, px"), tr("x, mm"), tr("y, mm"), tr("Depth, mm")}; }
  std::vector<CalibrationEntry> entries() const override {
    const auto entry = [](const QString& name, double lowest, double highest, double empty) {
      return CalibrationEntry{.name = name,
                              .units = {QStringLiteral("mm")},
                              .per_unit = {1.0},
                              .lowest = lowest,
                              .highest = highest,
                              .decimals = 1,
                              .empty = empty};
    };
    return {entry(tr("x, to the right"), -1000.0, 1000.0, calibration::kUnknown),
            entry(tr("y, to the back"), -1000.0, 1000.0, calibration::kUnknown),
            entry(tr("pressed down by"), 0.0, 25.0, 0.0)};
  }
  Result<std::vector<double>> read(const CalibrationScene& scene) const override {
    if (scene.picture.isNull()) return fail("there is no picture: look under Devices whether the camera answers");
    if (!scene.place_px) return fail("no place yet: click a mark of the target in the picture");
    return std::vector{scene.place_px->x(), scene.place_px->y()};
  }
  CalibrationPoint point(const std::vector<double>& entered, const std::vector<double>& mean,
                         const std::vector<double>&) const override {
    return {mean[0], mean[1], entered[0], entered[1], entered[2]};
  }
  std::vector<QPointF> marks(const std::vector<CalibrationPoint>& points) const override {
    std::vector<QPointF> out;
    out.reserve(points.size());
    for (const CalibrationPoint& point : points) out.emplace_back(point[0], point[1]);
    return out;
  }

  CalibrationFit fit(const std::vector<CalibrationPoint>& points, const station::Profile& profile) const override {
    const auto& p = profile.calibration;
    if (points.empty()) return noPoints(tr("At least %1 places, not on one line.").arg(p.camera_fewest_points));
    calibration::CameraSamples samples;
    for (const CalibrationPoint& point : points) {
      samples.x_px.push_back(point[0]);
      samples.y_px.push_back(point[1]);
      samples.x_mm.push_back(point[2]);
      samples.y_mm.push_back(point[3]);
      samples.depth_mm.push_back(point[4]);
    }
    const auto found = calibration::calibrateCamera(samples, p);
    CalibrationFit out{.result = found.result, .plot = {}, .legend = {}, .missing = {}};
    if (found.result.coefficients.size() > 4) {
      const calibration::Coefficient& height = found.result.coefficients[4];
      out.figures << tr("the camera is %1 ± %2 below the cloth")
                         .arg(widgets::numberText(height.value, 1),
                              widgets::quantityText(height.standard_error, 1, QStringLiteral("mm")));
    }
    const std::string& threshold = found.result.verdict.threshold;
    if (!found.result.verdict.accepted && threshold != "calibration.camera_held_out_mm") {
      out.missing = widgets::coreText(found.result.verdict.reason);
    }
    out.legend = tr("The target from above. Below, how far each mark is off. Crosses: points the others contradict.");
    out.plot = {.x_title = tr("x, mm"), .y_title = tr("y, mm"), .residual_title = tr("Error, mm")};
    for (const CalibrationPoint& point : points) out.plot.points.emplace_back(point[2], point[3]);
    out.plot.residuals = found.result.residuals;
    out.plot.outliers = found.result.outliers;
    return out;
  }

  std::vector<CalibrationPoint> simulatedPoints(const station::Profile& profile) const override {
    constexpr double kClick_px = 0.5;  // standard deviation of clicks on a mark
    std::mt19937_64 random(static_cast<std::uint64_t>(profile.sim.seed));
    std::normal_distribution<double> noise(0.0, kClick_px);
    std::vector<CalibrationPoint> out;
    for (const double depth_mm : {0.0, 8.0}) {
      for (const double y_mm : {-25.0, 0.0, 25.0}) {
        for (const double x_mm : {-40.0, 0.0, 40.0}) {
          const sim::Spot seen = sim::seenFromBelow({x_mm, y_mm}, depth_mm, profile.sim.cloth_height_mm);
          const sim::PicturePoint at = sim::pictureOf(seen.x_mm, seen.y_mm);
          out.push_back({at.u_px + noise(random), at.v_px + noise(random), x_mm, y_mm, depth_mm});
        }
      }
    }
    return out;
  }
};

}  // namespace

CalibrationSteps cameraScaleSteps(const station::Profile&) { return oneStep<CameraScaleStep>(); }

}  // namespace fyd::console
