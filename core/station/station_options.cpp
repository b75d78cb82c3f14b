#include "core/station/station_options.h"

namespace fyd::station {

StationOptions withProfileSources(StationOptions options) {
  const SourceParameters& sources = options.profile.sources;
  if (options.touchpad.empty()) {
    options.touchpad = sources.touchpad;
    if (options.motors.empty()) options.motors = sources.motors;
    if (options.camera.empty()) options.camera = sources.camera;
  }
  if (options.robot.empty()) {
    options.robot = sources.robot;
    if (options.key_file.empty()) options.key_file = sources.key_file;
  }
  return options;
}

}  // namespace fyd::station
