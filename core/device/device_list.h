// What is plugged in: serial ports and capture devices, by the names that stay the same whichever socket they are in.
#pragma once

#include <string>
#include <vector>

#include "core/base/message.h"

namespace fyd::device {

struct FoundDevice {
  std::string path;  ///< what to pass on: the stable name in /dev/serial/by-id or /dev/v4l/by-id where there is one
  std::string node;  ///< what it stands for now: /dev/ttyUSB0, /dev/video0
  std::string name;  ///< maker, model and serial number, or what the driver calls it; may be empty
  Message problem;   ///< why it cannot be opened, and the remedy; empty: it can
};

/// @param dev where the device files are; tests have their own
[[nodiscard]] std::vector<FoundDevice> findSerialPorts(const std::string& dev = "/dev");
[[nodiscard]] std::vector<FoundDevice> findCaptureDevices(const std::string& dev = "/dev");

}  // namespace fyd::device
