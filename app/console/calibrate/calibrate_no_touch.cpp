// The step that measures the untouched cloth: the offsets of the distance sensors and the load cell's zero. Like
// the tare, but nothing is changed before it is accepted.
#include <algorithm>
#include <cmath>

#include "app/console/calibrate/calibrate_step.h"
#include "core/calibration/rest_calibration.h"
#include "core/sensing/load_cell.h"
#include "core/sensing/tare.h"
#include "widgets/basics/number_text.h"
#include "widgets/basics/words.h"

namespace fyd::console {
namespace {

using widgets::tr;

class NoTouchStep : public CalibrationStep {
 public:
  explicit NoTouchStep(const station::Profile& profile) : indentation_(profile.step.sensing.indentation) {}
  void takeProfile(const station::Profile& profile) override { indentation_ = profile.step.sensing.indentation; }
  QString id() const override { return QStringLiteral("no-touch"); }
  std::string procedure() const override { return "no-touch"; }
  bool onePoint() const override { return true; }
  int interval_ms() const override { return kDistanceInterval_ms; }
  int readings() const override { return distanceReadings(indentation_); }
  QString instruction(const std::vector<CalibrationPoint>& points) const override {
    return points.empty()
               ? tr("Take everything off the cloth, keep your hands away, and take the point: it lasts %1 s.")
                     .arg(seconds())
               : tr("Look at the offsets at the right, then accept them or measure again.");
  }
  QStringList columns() const override { return {tr("Distances, mm"), tr("Force, N")}; }
  QStringList row(const CalibrationPoint& point) const override {
    QStringList distances;
    const std::size_t sensors = point.size() / 2 - 1;
    for (std::size_t i = 0; i < sensors; ++i) distances << widgets::numberText(point[i], 1);
    return {distances.join(QStringLiteral(" · ")), widgets::numberText(point[sensors], 3)};
  }

  std::vector<CalibrationSignal> signalsWanted(const station::Profile& profile) const override {
    std::vector<CalibrationSignal> out;
    const std::size_t sensors = profile.step.sensing.indentation.sensors();
    out.reserve(sensors);
    for (std::size_t i = 0; i < sensors; ++i) {
      out.push_back({tr("Distance %1").arg(i + 1), QStringLiteral("mm"), 1, sensing::Tare::kLargestSpread_mm});
    }
    out.push_back({tr("Force"), QStringLiteral("N"), 3, sensing::Tare::kLargestSpread_N});
    return out;
  }

  Result<std::vector<double>> read(const CalibrationScene& scene) const override {
    if (scene.newest.contact) return fail("the camera sees a finger on the cloth: take everything off");
    const auto& p = scene.profile.step.sensing;
    std::vector<double> out;
    for (std::size_t i = 0; i < p.indentation.sensors(); ++i) {
      const auto code = liveValue(scene.devices, say("IR sensor {}", i + 1));
      if (!code) return tl::unexpected(code.error());
      const auto read =
          distanceSensorOf(p.indentation, i).read(static_cast<std::uint16_t>(std::clamp(*code, 0.0, 4095.0)));
      if (!read.valid) {
        return fail("distance sensor {} reads {:.0f} counts, outside its span: look whether something stands before it",
                    i + 1, *code);
      }
      out.push_back(read.distance_mm);
    }
    const auto bridge = liveValue(scene.devices, say("load cell"));
    if (!bridge) return tl::unexpected(bridge.error());
    const double force_N = sensing::LoadCell(p.load_cell).force_N(*bridge);
    if (std::isnan(force_N)) return fail("load cell: {:.3f} mV/V lies beyond the bridge's span", *bridge);
    out.push_back(force_N);
    return out;
  }

  CalibrationPoint point(const std::vector<double>&, const std::vector<double>& mean,
                         const std::vector<double>& spread) const override {
    CalibrationPoint out = mean;
    out.insert(out.end(), spread.begin(), spread.end());
    return out;
  }

  CalibrationFit fit(const std::vector<CalibrationPoint>& points, const station::Profile& profile) const override {
    if (points.empty()) return noPoints(tr("One measurement of %1 s.").arg(seconds()));
    const CalibrationPoint& point = points.back();
    const std::size_t sensors = point.size() / 2 - 1;
    sensing::TareResult tare{.sensors = static_cast<std::uint32_t>(sensors)};
    for (std::size_t i = 0; i < sensors; ++i) {
      tare.offset_mm[i] = point[i];
      tare.spread_mm[i] = point[sensors + 1 + i];
    }
    tare.force_N = point[sensors];
    tare.force_spread_N = point.back();
    CalibrationFit out;
    out.result = calibration::judgeTare(sensing::TareState::done, tare, profile.step.sensing.load_cell.zero_N);
    out.legend = tr("Dots: measured. Dashed: the offsets in force.");
    out.plot = {.x_title = tr("Distance sensor"), .y_title = tr("Offset, mm"), .residual_title = tr("Change, mm")};
    for (std::size_t i = 0; i < sensors; ++i) {
      const auto x = static_cast<double>(i + 1);
      const ParameterList& former = profile.step.sensing.indentation.ir_offset_mm;
      out.plot.points.emplace_back(x, point[i]);
      if (i >= former.size()) continue;
      out.plot.former_curve.emplace_back(x, former[i]);
      out.plot.residuals.push_back(point[i] - former[i]);
    }
    return out;
  }

 private:
  [[nodiscard]] long seconds() const { return std::lround(readings() * interval_ms() / 1000.0); }

  sensing::IndentationParameters indentation_;
};

}  // namespace

CalibrationSteps noTouchSteps(const station::Profile& profile) { return oneStep<NoTouchStep>(profile); }

}  // namespace fyd::console
