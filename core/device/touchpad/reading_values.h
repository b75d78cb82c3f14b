// Raw readings as the rows of a device's report.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/device/device_report.h"
#include "core/device/touchpad/touchpad.h"

namespace fyd::device {

/// Codes and bridge value; those never received are left out.
void addSensorValues(const TouchpadReadings& readings, std::vector<ReportValue>& out);
/// Encoder counts, currents and, where known, the duty of the position loop; nothing before the first.
void addMotorValues(const Timed<control::MotorFeedback>& motors, std::vector<ReportValue>& out);

/// The value that carries the touchpad's serial number, and its text in a report; empty: it tells none.
[[nodiscard]] ReportValue serialValue(std::string_view serial);
[[nodiscard]] std::string serialIn(const DeviceReport& report);

}  // namespace fyd::device
