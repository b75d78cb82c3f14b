// Opens a touchpad by its name, as the command line and the profile write it.
#pragma once

#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/device/device_parameters.h"
#include "core/device/touchpad/qbmove_motors.h"
#include "core/device/touchpad/touchpad.h"

namespace fyd::device {

/// Whether the text names a motor board, as `openMotorBoard` reads it. Opens nothing.
[[nodiscard]] Result<void> checkMotorsName(const std::string& motors);

/// Whether the text names a touchpad, as `openTouchpad` reads it. Opens nothing.
[[nodiscard]] Result<void> checkTouchpadSource(const std::string& source);

/// Puts the original motor board in place of a touchpad's own motors.
/// @param motors "qbmove:TTY"; empty: the touchpad's own
[[nodiscard]] Result<std::unique_ptr<Touchpad>> withMotors(std::unique_ptr<Touchpad> touchpad,
                                                           const std::string& motors,
                                                           const DeviceParameters& parameters);

/// @param motors "qbmove:TTY"
/// @return an error when the text is wrong. An absent board is no error here: its exchanges fail.
[[nodiscard]] Result<std::unique_ptr<QbmoveMotors>> openMotorBoard(const std::string& motors,
                                                                   const DeviceParameters& parameters);

/// @param source "modbus-tcp:HOST:PORT" or "modbus-rtu:TTY[:BAUD]"
/// @return an error when the text is wrong. An absent device is no error here: its exchanges fail.
[[nodiscard]] Result<std::unique_ptr<Touchpad>> openTouchpad(const std::string& source,
                                                             const DeviceParameters& parameters);

/// Asks a touchpad that is not in use for its serial number; opens and closes its connection.
/// @param source as for `openTouchpad`; one that demands a serial number is not asked
/// @return empty when it tells none; an error when it does not answer in time or the text is wrong
[[nodiscard]] Result<std::string> readSerial(const std::string& source, const DeviceParameters& parameters);

}  // namespace fyd::device
