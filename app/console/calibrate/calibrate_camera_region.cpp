// The step that sets the cloth's region in the camera's picture, and the threshold between finger and cloth.
#include <algorithm>
#include <cmath>

#include "app/console/calibrate/calibrate_step.h"
#include "core/calibration/threshold_suggestion.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {
namespace {

using calibration::CalibrationResult;

using widgets::tr;

constexpr int kLeastSide_px = 16;  // as sensing.roi_width_px
constexpr int kGreys = 256;

/// Points are x, y, width, height of the region and then 256 counts of grey values in it.
class CameraRegionStep : public CalibrationStep {
 public:
  QString id() const override { return QStringLiteral("camera-region"); }
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
    result = {.procedure = procedure(), .curve = say("histogram"), .unit = "px", .points = 1, .valid_unit = "px"};
    result.changes = {{"sensing.roi_x_px", fmt::format("{:.0f}", point[0])},
                      {"sensing.roi_y_px", fmt::format("{:.0f}", point[1])},
                      {"sensing.roi_width_px", fmt::format("{:.0f}", point[2])},
                      {"sensing.roi_height_px", fmt::format("{:.0f}", point[3])}};
    result.verdict = {
        .accepted = true, .reason = say("region {:.0f} × {:.0f} px", point[2], point[3]), .threshold = {}};
    if (suggestion.plausible) {
      result.changes.push_back({"sensing.finger_threshold", fmt::format("{}", suggestion.threshold)});
      result.verdict.reason =
          listed({result.verdict.reason, say("finger at {:.0f}, cloth at {:.0f}, threshold {}", suggestion.finger_grey,
                                             suggestion.cloth_grey, suggestion.threshold)});
      const double x = suggestion.threshold;
      out.plot.former_curve = {{x, 0.0}, {x, most}};
      out.legend = tr("Line: grey values of the region. Dashed: the suggested threshold between finger and cloth.");
    } else {
      result.notes.push_back(say("no threshold is suggested, the present one stays: {}", suggestion.reason));
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

}  // namespace

CalibrationSteps cameraRegionSteps(const station::Profile&) { return oneStep<CameraRegionStep>(); }

}  // namespace fyd::console
