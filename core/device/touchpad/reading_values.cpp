#include "core/device/touchpad/reading_values.h"

namespace fyd::device {

void addSensorValues(const TouchpadReadings& readings, std::vector<ReportValue>& out) {
  for (std::size_t i = 0; i < readings.ir.value.size(); ++i) {
    out.push_back({.name = say("IR sensor {}", i + 1),
                   .number = static_cast<double>(readings.ir.value[i]),
                   .unit = std::string(sentence("counts"))});
  }
  if (readings.bridge.count > 0) {
    out.push_back({.name = say("load cell"), .number = readings.bridge.value.value_mV_per_V, .unit = "mV/V"});
  }
}

void addMotorValues(const Timed<control::MotorFeedback>& motors, std::vector<ReportValue>& out) {
  if (motors.count == 0) return;
  const control::MotorFeedback& feedback = motors.value;
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    out.push_back({.name = say("encoder {}", i + 1),
                   .number = static_cast<double>(feedback.encoder_counts[i]),
                   .unit = std::string(sentence("counts"))});
  }
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    out.push_back({.name = say("current {}", i + 1), .number = feedback.current_mA[i], .unit = "mA"});
  }
  for (std::size_t i = 0; i < control::kMotorCount && feedback.position_duty_known; ++i) {
    out.push_back({.name = say("position duty {}", i + 1), .number = feedback.position_duty_percent[i], .unit = "%"});
  }
}

ReportValue serialValue(std::string_view serial) {
  return {.name = say("serial number"), .unit = {}, .text = verbatim(serial)};
}

std::string serialIn(const DeviceReport& report) {
  const Message name = serialValue({}).name;
  for (const ReportValue& value : report.values) {
    if (value.name == name) return value.text.text();
  }
  return {};
}

}  // namespace fyd::device
