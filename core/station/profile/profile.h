// The settings of a touchpad that are kept between sessions: the step's parameters (calibrated values among them),
// the link's, the simulation's, the devices', the recorder's, what a calibration must reach, and which devices there
// are. One TOML file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/parameter.h"
#include "core/calibration/calibration_parameters.h"
#include "core/device/device_parameters.h"
#include "core/pipeline/parameters.h"
#include "core/protocol/link_parameters.h"
#include "core/recording/writer/recorder_options.h"
#include "core/sim/sim_parameters.h"
#include "core/station/profile/option_words.h"

namespace fyd::station {

/// The touchpad, motors, camera and robot that a station uses when its options name none.
struct SourceParameters {
  std::string touchpad = "simulated";
  std::string motors;
  std::string camera;
  std::string robot = "simulated";
  std::string key_file;

  template <class Visitor>
  void describe(Visitor& v) {
    v.text("station.touchpad", touchpad, {.help = words::kTouchpad});
    v.text("station.motors", motors, {.help = words::kMotors});
    v.text("station.camera", camera, {.help = words::kCamera});
    v.text("station.robot", robot, {.help = words::kRobot});
    v.text("station.key_file", key_file, {.help = words::kKey});
  }
};

struct Profile {
  pipeline::Parameters step;
  protocol::LinkParameters link;
  sim::SimParameters sim;
  device::DeviceParameters device;
  calibration::CalibrationParameters calibration;
  std::string calibrated_on;  ///< touchpad that the calibrated values belong to, as touchpad_name.h; empty: not known
  recording::RecorderOptions session;
  SourceParameters sources;

  /// The step's parameters come first, so that an index counts the same here and in the step.
  template <class Visitor>
  void describe(Visitor& v) {
    step.describe(v);
    link.describe(v);
    sim.describe(v);
    device.describe(v);
    calibration.describe(v);
    v.text("calibration.touchpad", calibrated_on, {.help = words::kCalibratedOn});
    session.describe(v);
    sources.describe(v);
  }
};

inline constexpr std::uintmax_t kLargestProfile_bytes = 1 << 20;

/// @return an error naming file, line, value and range; nothing is half loaded
[[nodiscard]] Result<Profile> loadProfile(const std::string& path);

/// Writes the whole file beside `path`, syncs it and renames it over: a reader sees the old or the new one, never half.
[[nodiscard]] Result<void> saveProfile(const Profile& profile, const std::string& path);

}  // namespace fyd::station

extern template std::vector<fyd::Parameter> fyd::bindParameters(fyd::station::Profile& instance);
