// Help texts of a station's options, the same at the command line and in the window.
#pragma once

#include "core/base/message.h"

namespace fyd::station::words {

inline constexpr const char* kTouchpad = "simulated, modbus-tcp:HOST:PORT, modbus-rtu:TTY[:BAUD] or recording:FILE";
inline constexpr const char* kCalibratedOn =
    "Touchpad that the calibrated values belong to: serial:NUMBER or its address; empty: not known";
inline constexpr const char* kMotors = "qbmove:TTY, the original motor board in place of the touchpad's own motors";
inline constexpr const char* kFinger =
    "Gesture card or recording the simulated finger follows (columns t_s,x_mm,y_mm,z_mm)";
inline constexpr const char* kCamera =
    "Device index, video file, folder of pictures, stream URL or recording:FILE; left out, the touchpad's own "
    "(simulated, recorded)";
inline constexpr const char* kRobot =
    "simulated (simulated:PREDICTOR), scene:FILE, none, or link:HOST:PORT or classic:HOST:PORT to listen there";
inline constexpr const char* kKey = "Key file of FYD Link, for --robot link:HOST:PORT";
inline constexpr const char* kScene =
    "Scene that is felt here, whichever robot follows the finger beside it: a file, or the name of one that comes "
    "along";
inline constexpr const char* kSurface =
    "Stored surface to feel with --robot none: a file (TOML), or the name of one that comes along";
inline constexpr const char* kRecord = "Record the session into this new file (.h5)";
inline constexpr const char* kOperator = "Who operates, for the recording";
inline constexpr const char* kSubject = "Code of the subject, never a name, for the recording";
inline constexpr const char* kNotes = "A line about the session, for the recording";
inline constexpr const char* kCatalogue =
    "Catalogue of sessions: sqlite:PATH, postgresql:host=… dbname=… user=… or none; default: this user's own";
inline constexpr const char* kTag = "A word to find the recording by; may be given again";

/// The message when options describe a recording but --record is missing.
inline constexpr std::string_view kRecordMissing =
    sentence("--operator, --subject, --notes and --tag describe a recording; add --record FILE");
[[nodiscard]] inline Message contradiction(const std::string& touchpad) {
  return say("--simulate contradicts --touchpad {}", touchpad);
}

}  // namespace fyd::station::words
