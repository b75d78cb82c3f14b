// What a session is opened with: its profile, the sources of its parts, what is recorded.
#pragma once

#include <optional>
#include <string>

#include "core/recording/writer/recorder_types.h"
#include "core/station/profile/profile.h"

namespace fyd::station {

struct StationOptions {
  Profile profile;
  std::string profile_file;  ///< where calibrated values of the touchpad are looked for when `profile` has those of
                             ///< another one (calibrated_values.h); empty: nowhere
  std::string finger_csv;  ///< recording the simulated finger follows; empty: the built-in gesture
  std::string touchpad;    ///< "simulated", "modbus-tcp:HOST:PORT", "modbus-rtu:TTY[:BAUD]" or "recording:FILE": played
                           ///< back, motors not driven; empty: the profile's
  std::string motors;      ///< "qbmove:TTY" in place of the touchpad's own motors; empty: its own
  std::string camera;      ///< device index, file, folder, URL, "recording:FILE"; empty: the touchpad's own
  std::string robot;       ///< "simulated[:PREDICTOR]", "scene:FILE", "none", "link:HOST:PORT" or "classic:HOST:PORT"
                           ///< (listens there); empty: the profile's
  std::string key_file;    ///< of FYD Link; "link:" needs one, the others take none
  std::string scene;       ///< file of a scene that is touched here, with any robot; empty: robot's "scene:FILE"
  std::string surface;     ///< file of a stored surface, touched while robot is "none"; empty: none
  /// Where every part is simulated in this process, the session's clock waits for a late computer and nothing is Held
  /// for it; true: lateness is a fault there too, as it is with any real or remote part.
  bool real_time = false;
  std::optional<recording::RecordingRequest> record;  ///< recorded from the first step on
};

/// Fills empty options from the profile. A touchpad named in the options comes with its own motors and camera: those of
/// the profile belong to the profile's touchpad. `Station::open` does this by itself.
[[nodiscard]] StationOptions withProfileSources(StationOptions options);

}  // namespace fyd::station
