#include "app/console/calibrate/calibrate_step.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "core/calibration/calibration_part.h"
#include "widgets/basics/core_text.h"
#include "widgets/basics/number_text.h"

namespace fyd::console {

QString CalibrationStep::name() const { return widgets::coreText(calibration::partName(procedure(), sensor())); }

bool CalibrationStep::readWith(std::string_view calibration) const {
  return std::ranges::any_of(calibration::dependences(), [&](const calibration::Dependence& rests) {
    return rests.part == procedure() && rests.basis == calibration;
  });
}

QStringList CalibrationStep::row(const CalibrationPoint& point) const {
  QStringList out;
  for (const double value : point) {
    const int digits_before = std::abs(value) >= 1.0 ? 1 + static_cast<int>(std::log10(std::abs(value))) : 1;
    out << widgets::numberText(value, std::clamp(5 - digits_before, 0, 4));
  }
  return out;
}

Result<double> liveValue(const std::vector<device::DeviceReport>& devices, const Message& name) {
  constexpr double kStale_ms = 500.0;
  for (const device::DeviceReport& device : devices) {
    for (const device::ReportValue& value : device.values) {
      if (value.name != name || !value.text.empty()) continue;
      if (!device.ok && !device.measures)
        return fail("{} does not answer: {}", phrase(toString(device.part)), device.problem);
      if (!(device.age_ms <= kStale_ms))
        return fail("{}'s newest reading is {:.0f} ms old", phrase(toString(device.part)), device.age_ms);
      if (!std::isfinite(value.number)) return fail("{} is not known: check its cable", name);
      return value.number;
    }
  }
  return fail("no device tells '{}': look under Devices whether the touchpad answers", name);
}

int distanceReadings(const sensing::IndentationParameters& p) {
  constexpr double kHold_s = 11.0, kUsualNoise_mV = 10.0;
  constexpr double kFewest = 50, kMost = 3000;
  const double noise = p.ir_noise_mV / kUsualNoise_mV;
  return static_cast<int>(std::clamp(kHold_s * 1000.0 / kDistanceInterval_ms * noise * noise, kFewest, kMost));
}

sensing::IrDistance distanceSensorOf(const sensing::IndentationParameters& p, std::size_t sensor) {
  const auto code = [sensor](const ParameterList& list, int otherwise) {
    return sensor < list.size() ? static_cast<int>(list[sensor]) : otherwise;
  };
  constexpr int kLowest = 524, kHighest = 3408;  // defaults of sensing.ir_lowest_code and sensing.ir_highest_code
  return {p.ir_curve_mm[sensor].view(), code(p.ir_lowest_code, kLowest), code(p.ir_highest_code, kHighest),
          p.ir_curve_form[sensor]};
}

QString missingOf(const calibration::CalibrationResult& result) {
  return result.verdict.too_few ? widgets::coreText(result.verdict.reason) : QString();
}

std::vector<double> columnOf(const std::vector<CalibrationPoint>& points, std::size_t column) {
  std::vector<double> out;
  out.reserve(points.size());
  for (const CalibrationPoint& point : points) out.push_back(point[column]);
  return out;
}

CalibrationFit curveFit(const calibration::CalibrationResult& result, const std::vector<CalibrationPoint>& points,
                        widgets::FitView titles) {
  CalibrationFit out{
      .result = result,
      .plot = std::move(titles),
      .legend = QCoreApplication::translate(
          "CalibrationStep", "Line: new curve. Dashed: the one in force. Crosses: points the others contradict."),
      .missing = missingOf(result)};
  for (const CalibrationPoint& point : points) out.plot.points.emplace_back(point[0], point[1]);
  out.plot.residuals = result.residuals;
  out.plot.outliers = result.outliers;
  return out;
}

CalibrationEntry stretchEntry(double lowest_deg, double highest_deg) {
  return {.name = QCoreApplication::translate("CalibrationStep", "Stretch"),
          .units = {QStringLiteral("°")},
          .per_unit = {1.0},
          .lowest = lowest_deg,
          .highest = highest_deg,
          .decimals = 1};
}

CalibrationFit noPoints(const QString& missing) {
  CalibrationFit out;
  out.missing = missing;
  out.plot.empty_text = QCoreApplication::translate("CalibrationStep",
                                                    "The fit and its residuals are drawn here.\n\n"
                                                    "To begin: %1")
                            .arg(missing);
  return out;
}

}  // namespace fyd::console
