// Steps that look at the camera's picture: the cloth's region with the finger's threshold, and the scale from a printed
// target.
#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <random>

#include "app/console/calibrate_step.h"
#include "core/calibration/camera_calibration.h"
#include "core/calibration/threshold_suggestion.h"
#include "core/sensing/finger_detector.h"
#include "core/sim/picture.h"
#include "widgets/number_text.h"

namespace fyd::console {
namespace {

using calibration::CalibrationResult;

QString tr(const char* text) { return QCoreApplication::translate("CalibrationStep", text); }

constexpr int kLeastSide_px = 16;  // as sensing.roi_width_px
constexpr int kGreys = 256;

/// Points are x, y, width, height of the region and then 256 counts of grey values in it.
class CameraRegionStep : public CalibrationStep {
 public:
  QString id() const override { return QStringLiteral("camera-region"); }
  QString name() const override { return tr("Camera: region, threshold"); }
  std::string procedure() const override { return "camera-region"; }
  bool onePoint() const override { return true; }
  int readings() const override { return 1; }
  Picture picture() const override { return Picture::rectangle; }
  QString instruction(const std::vector<CalibrationPoint>&) const override {
    return tr("Rest a finger on the cloth, drag a rectangle around the cloth in the picture, and take the point.");
  }
  QStringList columns() const override { return {tr("Left"), tr("Top"), tr("Width"), tr("Height")}; }
  QStringList row(const CalibrationPoint& point) const override {
    QStringList out;
    for (std::size_t i = 0; i < 4; ++i) out << widgets::numberText(point[i], 0);
    return out;
  }

  Result<std::vector<double>> read(const CalibrationScene& scene) const override {
    if (scene.picture.isNull()) return fail("there is no picture: look under Devices whether the camera answers");
    const QRect region = scene.rectangle_px.intersected(scene.picture.rect());
    if (region.isEmpty()) return fail("no region yet: drag a rectangle around the cloth in the picture");
    if (region.width() < kLeastSide_px || region.height() < kLeastSide_px) {
      return fail("the region is {} × {} px; expected at least {} px each way: drag a larger one", region.width(),
                  region.height(), kLeastSide_px);
    }
    std::vector<double> out = {static_cast<double>(region.x()), static_cast<double>(region.y()),
                               static_cast<double>(region.width()), static_cast<double>(region.height())};
    out.resize(4 + kGreys, 0.0);
    const QImage grey = scene.picture.copy(region).convertToFormat(QImage::Format_Grayscale8);
    for (int y = 0; y < grey.height(); ++y) {
      const uchar* line = grey.constScanLine(y);
      for (int x = 0; x < grey.width(); ++x) out[4 + line[x]] += 1.0;
    }
    return out;
  }
  CalibrationPoint point(const std::vector<double>&, const std::vector<double>& mean,
                         const std::vector<double>&) const override {
    return mean;
  }

  CalibrationFit fit(const std::vector<CalibrationPoint>& points, const station::Profile&) const override {
    if (points.empty()) return noPoints(tr("A rectangle around the cloth, with a finger in it."));
    const CalibrationPoint& point = points.back();
    CalibrationFit out;
    out.plot = {.x_title = tr("Grey value"), .y_title = tr("Pixels"), .residual_title = {}};
    std::array<std::uint64_t, kGreys> histogram{};
    double most = 0.0;
    for (std::size_t i = 0; i < kGreys; ++i) {
      histogram[i] = static_cast<std::uint64_t>(point[4 + i]);
      most = std::max(most, point[4 + i]);
      out.plot.curve.emplace_back(static_cast<double>(i), point[4 + i]);
    }
    const auto suggestion = calibration::suggestThreshold(histogram);
    CalibrationResult& result = out.result;
    result = {.procedure = procedure(), .curve = "histogram", .unit = "px", .points = 1, .valid_unit = "px"};
    result.changes = {{"sensing.roi_x_px", fmt::format("{:.0f}", point[0])},
                      {"sensing.roi_y_px", fmt::format("{:.0f}", point[1])},
                      {"sensing.roi_width_px", fmt::format("{:.0f}", point[2])},
                      {"sensing.roi_height_px", fmt::format("{:.0f}", point[3])}};
    result.verdict = {true, fmt::format("region {:.0f} × {:.0f} px", point[2], point[3]), {}};
    if (suggestion.plausible) {
      result.changes.push_back({"sensing.finger_threshold", fmt::format("{}", suggestion.threshold)});
      result.verdict.reason += fmt::format("; finger at {:.0f}, cloth at {:.0f}, threshold {}", suggestion.finger_grey,
                                           suggestion.cloth_grey, suggestion.threshold);
      const double x = suggestion.threshold;
      out.plot.former_curve = {{x, 0.0}, {x, most}};
      out.legend = tr("Line: grey values of the region. Dashed: the suggested threshold between finger and cloth.");
    } else {
      result.notes.push_back("no threshold is suggested, the present one stays: " + suggestion.reason);
    }
    return out;
  }

  std::vector<CalibrationPoint> simulatedPoints(const station::Profile& profile) const override {
    // The simulated cloth and a finger of 6 mm pressed on it, with the camera's noise.
    constexpr double kCloth = 215.0, kFinger = 60.0, kClothPixels = 32000.0, kFingerPixels = 1000.0;
    constexpr double kLightSpread = 12.0;  // the vignette's
    const auto peak = [](double grey, double mean, double sigma, double pixels) {
      return pixels / (sigma * 2.5066) * std::exp(-0.5 * (grey - mean) * (grey - mean) / (sigma * sigma));
    };
    CalibrationPoint out = {40.0, 45.0, 220.0, 150.0};
    for (int grey = 0; grey < kGreys; ++grey) {
      out.push_back(std::round(peak(grey, kCloth, kLightSpread, kClothPixels) +
                               peak(grey, kFinger, 2.0 + profile.sim.camera_noise, kFingerPixels)));
    }
    return {out};
  }
};

class CameraScaleStep : public CalibrationStep {
 public:
  QString id() const override { return QStringLiteral("camera"); }
  QString name() const override { return tr("Camera: scale"); }
  std::string procedure() const override { return "camera"; }
  int readings() const override { return 1; }
  Picture picture() const override { return Picture::place; }
  QString instruction(const std::vector<CalibrationPoint>& points) const override {
    return points.empty() ? tr("Lay the printed target on the cloth, click one of its marks in the picture, type where "
                               "it lies, and take the point.")
                          : tr("Click the next mark, type where it lies, and take the point: best at the cloth's "
                               "corners and in its middle.");
  }
  QStringList columns() const override { return {tr("x, px"), tr("y, px"), tr("x, mm"), tr("y, mm")}; }
  std::vector<CalibrationEntry> entries() const override {
    const auto entry = [](const QString& name) {
      return CalibrationEntry{.name = name,
                              .units = {QStringLiteral("mm")},
                              .per_unit = {1.0},
                              .lowest = -1000.0,
                              .highest = 1000.0,
                              .decimals = 1};
    };
    return {entry(tr("x, to the right")), entry(tr("y, to the back"))};
  }
  Result<std::vector<double>> read(const CalibrationScene& scene) const override {
    if (scene.picture.isNull()) return fail("there is no picture: look under Devices whether the camera answers");
    if (!scene.place_px) return fail("no place yet: click a mark of the target in the picture");
    return std::vector{scene.place_px->x(), scene.place_px->y()};
  }
  CalibrationPoint point(const std::vector<double>& entered, const std::vector<double>& mean,
                         const std::vector<double>&) const override {
    return {mean[0], mean[1], entered[0], entered[1]};
  }
  std::vector<QPointF> marks(const std::vector<CalibrationPoint>& points) const override {
    std::vector<QPointF> out;
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
    }
    const auto found = calibration::calibrateCamera(samples, p);
    CalibrationFit out{.result = found.result, .plot = {}, .legend = {}, .missing = {}};
    const std::string& threshold = found.result.verdict.threshold;
    if (!found.result.verdict.accepted && threshold != "calibration.camera_held_out_mm") {
      out.missing = QString::fromStdString(found.result.verdict.reason);
    }
    out.legend = tr("The target from above. Below, how far each mark is off. Crosses: points the others contradict.");
    out.plot = {.x_title = tr("x, mm"), .y_title = tr("y, mm"), .residual_title = tr("Error, mm")};
    for (const CalibrationPoint& point : points) out.plot.points.emplace_back(point[2], point[3]);
    out.plot.residuals = found.result.residuals;
    out.plot.outliers = found.result.outliers;
    return out;
  }

  std::vector<CalibrationPoint> simulatedPoints(const station::Profile& profile) const override {
    constexpr double kClick_px = 0.5;  // how well a mark is hit
    std::mt19937_64 random(static_cast<std::uint64_t>(profile.sim.seed));
    std::normal_distribution<double> noise(0.0, kClick_px);
    std::vector<CalibrationPoint> out;
    for (const double y_mm : {-25.0, 0.0, 25.0}) {
      for (const double x_mm : {-40.0, 0.0, 40.0}) {
        const sim::PicturePoint at = sim::pictureOf(x_mm, y_mm);
        out.push_back({at.u_px + noise(random), at.v_px + noise(random), x_mm, y_mm});
      }
    }
    return out;
  }
};

}  // namespace

std::unique_ptr<CalibrationStep> makeCameraRegionStep() { return std::make_unique<CameraRegionStep>(); }
std::unique_ptr<CalibrationStep> makeCameraScaleStep() { return std::make_unique<CameraScaleStep>(); }

}  // namespace fyd::console
