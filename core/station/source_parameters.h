// Which touchpad, motors, camera and robot a laboratory's station works with, as its profile keeps them.
#pragma once

#include <string>

#include "core/base/parameter.h"
#include "core/station/option_words.h"

namespace fyd::station {

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

}  // namespace fyd::station
