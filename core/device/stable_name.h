// Devices by what they are, not by where they are plugged in: "id=SERIAL" stands for the one device whose stable name
// in /dev/serial/by-id or /dev/v4l/by-id contains SERIAL as a whole word.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"

namespace fyd::device {

inline constexpr std::string_view kSerialById = "/dev/serial/by-id";
inline constexpr std::string_view kCamerasById = "/dev/v4l/by-id";

/// Asked anew at each opening, because the node behind a name changes when the device is plugged in again.
/// A camera shows several nodes; its pictures come from the one that ends in "-video-index0", and only those are looked
/// at unless SERIAL says otherwise.
/// @param text a path, which is passed on, or "id=SERIAL"
/// @param folder of links that carry maker, model and serial number; tests have their own
/// @return the path to open, or an error when no device or more than one fits, with what there is
[[nodiscard]] Result<std::string> resolveDevice(const std::string& text, std::string_view folder);

/// The folder that a test chose, or the system's.
[[nodiscard]] inline std::string_view folderOr(std::string_view chosen, std::string_view usual) {
  return chosen.empty() ? usual : chosen;
}

}  // namespace fyd::device
