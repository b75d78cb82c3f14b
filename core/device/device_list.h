// Lists the connected serial ports and capture devices, by names that do not depend on the socket they are plugged
// into.
#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"

namespace fyd::device {

struct FoundDevice {
  std::string path;  ///< to open it by: the stable name in /dev/serial/by-id or /dev/v4l/by-id, else the node
  std::string node;  ///< the device node it points to now: /dev/ttyUSB0, /dev/video0
  std::string name;  ///< maker, model and serial number, or what the driver calls it; may be empty
  Message problem;   ///< why it cannot be opened, and the remedy; empty: it can
};

/// @param dev folder of the device files; tests pass their own
[[nodiscard]] std::vector<FoundDevice> findSerialPorts(const std::string& dev = "/dev");
[[nodiscard]] std::vector<FoundDevice> findCaptureDevices(const std::string& dev = "/dev");

}  // namespace fyd::device
