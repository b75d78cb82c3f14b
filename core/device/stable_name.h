// Devices by serial number, not by socket: "id=SERIAL" stands for the one device whose stable name in /dev/serial/by-id
// or /dev/v4l/by-id contains SERIAL as a whole word.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"

namespace fyd::device {

inline constexpr std::string_view kSerialById = "/dev/serial/by-id";
inline constexpr std::string_view kCamerasById = "/dev/v4l/by-id";

/// Called at each opening, because the node behind a name changes when the device is plugged in again.
/// A camera has several nodes; its pictures come from the one whose name ends in "-video-index0". Only those are
/// considered unless SERIAL contains "-video-index".
/// @param text a path, which is passed on, or "id=SERIAL"
/// @param folder of links that carry maker, model and serial number; tests pass their own
/// @return the path to open; or, when no device or more than one fits, an error that lists the devices found
[[nodiscard]] Result<std::string> resolveDevice(const std::string& text, std::string_view folder);

/// The folder that a test chose, or the system's.
[[nodiscard]] inline std::string_view folderOr(std::string_view chosen, std::string_view usual) {
  return chosen.empty() ? usual : chosen;
}

/// A source as it may be shown and recorded: without the user and password of a URL.
[[nodiscard]] std::string withoutSecrets(std::string_view source);

}  // namespace fyd::device
