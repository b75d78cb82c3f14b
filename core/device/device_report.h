// What one device says of itself, for the devices page and `fyd devices`: which it is, live values, error counters.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace fyd::device {

/// One live value. `text` where it is a word; otherwise `number` with `unit`, NaN when it is not known.
struct ReportValue {
  std::string name;
  double number = std::numeric_limits<double>::quiet_NaN();
  std::string unit;
  std::string text;
};

/// How often one kind of error has happened since the start.
struct ErrorCount {
  std::string kind;
  std::uint64_t count = 0;
};

/// A control of a camera: what the profile wants and what the source made of it, percent of the driver's range.
struct CameraControl {
  std::string name;                                          ///< "brightness", "contrast", "exposure"
  double wanted = std::numeric_limits<double>::quiet_NaN();  ///< NaN: left as it is
  double actual = std::numeric_limits<double>::quiet_NaN();  ///< NaN: the source does not tell
  bool supported = false;
  std::string words;  ///< "set to 100 %", "this source has none", …
};

struct DeviceReport {
  std::string name;         ///< "Touchpad", "Motor board", "Camera"
  std::string kind;         ///< "simulated", "Modbus TCP", "Modbus RTU", "qbmove", …
  std::string description;  ///< which one it is: port, serial number, firmware
  bool ok = false;
  std::string problem;                                       ///< empty when ok; says what to do otherwise
  double rate_hz = 0.0;                                      ///< answers or pictures in the last second
  double age_ms = std::numeric_limits<double>::quiet_NaN();  ///< of the newest; NaN before the first
  std::uint64_t errors = 0;                                  ///< exchanges or pictures that failed
  std::vector<ErrorCount> counters;                          ///< the same by kind, where the device tells them apart
  std::vector<ReportValue> values;
  std::vector<CameraControl> controls;  ///< cameras only
};

}  // namespace fyd::device
