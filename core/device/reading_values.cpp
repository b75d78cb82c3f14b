#include "core/device/reading_values.h"

namespace fyd::device {

void addSensorValues(const TouchpadReadings& readings, std::vector<ReportValue>& out) {
  for (std::size_t i = 0; i < readings.ir.value.size(); ++i) {
    out.push_back({.name = fmt::format("IR sensor {}", i + 1),
                   .number = static_cast<double>(readings.ir.value[i]),
                   .unit = "counts"});
  }
  if (readings.bridge.count > 0) {
    out.push_back({.name = "load cell", .number = readings.bridge.value.value_mV_per_V, .unit = "mV/V"});
  }
}

void addMotorValues(const Timed<control::MotorFeedback>& motors, std::vector<ReportValue>& out) {
  if (motors.count == 0) return;
  const control::MotorFeedback& feedback = motors.value;
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    out.push_back({.name = fmt::format("encoder {}", i + 1),
                   .number = static_cast<double>(feedback.encoder_counts[i]),
                   .unit = "counts"});
  }
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    out.push_back({.name = fmt::format("current {}", i + 1), .number = feedback.current_mA[i], .unit = "mA"});
  }
  for (std::size_t i = 0; i < control::kMotorCount && feedback.position_duty_known; ++i) {
    out.push_back(
        {.name = fmt::format("position duty {}", i + 1), .number = feedback.position_duty_percent[i], .unit = "%"});
  }
}

}  // namespace fyd::device
