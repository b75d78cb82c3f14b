// Whether the touchpad, motors, camera and robot that somebody chose can be had: asked before the present session ends
// for them.
#pragma once

#include <functional>
#include <vector>

#include "core/device/device_report.h"
#include "core/station/profile/profile.h"

namespace fyd::station {

/// Why a part cannot be had.
struct ConnectionProblem {
  device::Part part = device::Part::touchpad;
  Message message;
};

/// Asks each part once, as `fyd devices` does, with the motors off: a touchpad and a motor board have to answer, a
/// camera has to give a picture, files have to be there, a scene is read. It takes up to some seconds; a camera that is
/// there and silent, ten.
/// @param wanted words as in StationOptions, of every part
/// @param in_use words of the present session: a part that it has already is not asked, because it holds the port
/// @return the parts that cannot be had; none: all can
[[nodiscard]] std::vector<ConnectionProblem> checkConnection(const SourceParameters& wanted,
                                                             const SourceParameters& in_use,
                                                             const device::DeviceParameters& parameters);

}  // namespace fyd::station
