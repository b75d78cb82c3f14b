// Report of one device for the devices page and `fyd devices`: identity, live values, error counters.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/base/message.h"

namespace fyd::device {

enum class Part : std::uint8_t { touchpad, motor_board, camera, robot };

[[nodiscard]] constexpr std::string_view toString(Part part) {
  constexpr std::array<std::string_view, 4> kNames = {sentence("Touchpad"), sentence("Motor board"), sentence("Camera"),
                                                      sentence("Robot")};
  return kNames[static_cast<std::size_t>(part)];
}

/// One live value. `text` where it is a word (or a serial number); otherwise `number` with `unit`, NaN when it is not
/// known.
struct ReportValue {
  Message name;
  double number = std::numeric_limits<double>::quiet_NaN();
  std::string unit;  ///< "counts" is translated, the others are symbols
  Message text;
};

/// How often one kind of error has happened since the start.
struct ErrorCount {
  Message kind;
  std::uint64_t count = 0;
};

/// A control of a camera: wanted by the profile and read back from the source, percent of the driver's range.
struct CameraControl {
  Message name;                                              ///< "brightness", "contrast", "exposure"
  double wanted = std::numeric_limits<double>::quiet_NaN();  ///< NaN: left as it is
  double actual = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not known from the source
  bool supported = false;
  Message words;  ///< "set to 100 %", "this source has none", …
};

struct DeviceReport {
  Part part = Part::touchpad;
  Message kind;            ///< "simulated", "Modbus TCP", "Modbus RTU", "qbmove", …
  Message description;     ///< which one it is: port, serial number, firmware
  bool simulated = false;  ///< its values are computed in this program, nothing is measured
  bool ok = false;
  Message problem;                                           ///< empty when ok; otherwise with the remedy
  bool in_use = false;                                       ///< the problem: it is there, and another program has it
  bool measures = false;                                     ///< there is a problem, but only with its motors
  double rate_hz = 0.0;                                      ///< answers or pictures in the last second
  double age_ms = std::numeric_limits<double>::quiet_NaN();  ///< of the newest; NaN before the first
  std::uint64_t errors = 0;                                  ///< exchanges or pictures that failed
  std::vector<ErrorCount> counters;                          ///< the same by kind, where the device distinguishes them
  std::vector<ReportValue> values;
  std::vector<CameraControl> controls;  ///< cameras only
};

}  // namespace fyd::device
