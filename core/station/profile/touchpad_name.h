// Which touchpad a profile's calibrated values, and a calibration's record, belong to. As text:
//
//   simulated        the simulated touchpad of this process, whatever its seed
//   recording        a recording that is played back
//   serial:NUMBER    the touchpad that tells this serial number
//   modbus-tcp:…     the one at this address, when it tells none
//   (empty)          not known
//
// Motors with a board of their own follow: "serial:A7 with qbmove:id=B2".
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"

namespace fyd::station {

inline constexpr std::string_view kSimulatedTouchpad = "simulated";
inline constexpr std::string_view kPlayedTouchpad = "recording";
inline constexpr std::string_view kSerialTouchpad = "serial:";

/// @param motors as in StationOptions; empty: the touchpad's own
[[nodiscard]] std::string touchpadName(std::string_view touchpad, std::string_view motors);

/// Whether it is a name that a touchpad, other than one played back, can have.
[[nodiscard]] Result<void> checkTouchpadName(const std::string& name);

/// Whether its readings come from the simulator of this process.
[[nodiscard]] bool isSimulated(std::string_view name);
[[nodiscard]] bool isPlayed(std::string_view name);

/// The serial number in the name; empty: none.
[[nodiscard]] std::string serialIn(std::string_view name);

/// "the simulated touchpad", "the touchpad with serial number A7", "a touchpad that is not known".
[[nodiscard]] Message describeTouchpad(std::string_view name);

}  // namespace fyd::station
