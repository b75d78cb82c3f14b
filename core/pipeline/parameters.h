// The step's parameters, gathered from the modules that declare them.
// Stability: stable since 0.1
#pragma once

#include <vector>

#include "core/base/api.h"
#include "core/base/message.h"
#include "core/base/parameter.h"
#include "core/control/control_parameters.h"
#include "core/sensing/sensing_parameters.h"
#include "core/teleop/coupling/touchpad_coupling.h"
#include "core/texture/texture_parameters.h"

namespace fyd::pipeline {

/// How the step itself judges its inputs and moves the robot.
struct StepParameters {
  double finger_maximum_age_ms = 250.0;
  double ir_maximum_age_ms = 100.0;
  double bridge_maximum_age_ms = 100.0;
  double motors_maximum_age_ms = 50.0;
  bool absolute_motion = false;  ///< the thesis' way: the robot goes where the finger is
  double motion_scale = 1.0;
  double motion_depth_scale = 1.0;
  double motion_speed_limit_mm_s = 200.0;
  double hand_target_N_per_mm = 0.6;
  teleop::TouchpadCouplingChoice coupling = teleop::TouchpadCouplingChoice::model;

  template <class Visitor>
  void describe(Visitor& v) {
    v.real("pipeline.finger_maximum_age_ms", finger_maximum_age_ms,
           {.unit = "ms", .minimum = 20, .maximum = 2000, .help = sentence("Oldest picture the step still trusts.")});
    v.real("pipeline.ir_maximum_age_ms", ir_maximum_age_ms,
           {.unit = "ms",
            .minimum = 20,
            .maximum = 1000,
            .help = sentence("Oldest distance reading the step still trusts.")});
    v.real("pipeline.bridge_maximum_age_ms", bridge_maximum_age_ms,
           {.unit = "ms",
            .minimum = 10,
            .maximum = 1000,
            .help = sentence("Oldest load-cell reading the step still trusts.")});
    v.real("pipeline.motors_maximum_age_ms", motors_maximum_age_ms,
           {.unit = "ms",
            .minimum = 5,
            .maximum = 1000,
            .help = sentence("Oldest encoder reading the step still trusts.")});
    v.boolean("pipeline.absolute_motion", absolute_motion,
              {.help = sentence("Thesis mode: the robot goes where the finger is, with a jump at each new touch; off: "
                                "each touch moves it from where it stands.")});
    v.real("pipeline.motion_scale", motion_scale,
           {.name = sentence("Motion scale"),
            .minimum = 0.05,
            .maximum = 5,
            .help = sentence("Robot's travel for the finger's along the cloth."),
            .live = true});
    v.real("pipeline.motion_depth_scale", motion_depth_scale,
           {.name = sentence("Motion depth scale"),
            .minimum = 0.05,
            .maximum = 5,
            .help = sentence("Robot's travel downward for the finger's indentation."),
            .live = true});
    v.real("pipeline.motion_speed_limit_mm_s", motion_speed_limit_mm_s,
           {.name = sentence("Motion speed limit"),
            .unit = "mm/s",
            .minimum = 1,
            .maximum = 1000,
            .help = sentence("Fastest the position sent to the robot moves along each axis."),
            .live = true});
    v.real("pipeline.hand_target_N_per_mm", hand_target_N_per_mm,
           {.name = sentence("Hand target"),
            .unit = "N/mm",
            .minimum = teleop::kLeastTarget_N_per_mm,
            .maximum = teleop::kMostTarget_N_per_mm,
            .help = sentence("Stiffness target while it is set by hand."),
            .live = true});
    v.choice("pipeline.coupling", coupling, teleop::kTouchpadCouplingNames,
             {.name = sentence("Coupling"),
              .help = sentence("How the cloth gets its target: direct takes the robot's stiffness as it comes, spring "
                               "its force over the indentation, tdpa the same within the energy that the finger put "
                               "in, model keeps an estimate that stiffens out of contact or at another place."),
              .live = true,
              .before_it_was = static_cast<double>(teleop::TouchpadCouplingChoice::direct)});
  }
};

struct Parameters {
  StepParameters step;
  sensing::SensingParameters sensing;
  control::ControlParameters control;
  texture::TextureParameters texture;

  template <class Visitor>
  void describe(Visitor& v) {
    step.describe(v);
    sensing.describe(v);
    control.describe(v);
    texture.describe(v);
  }
};

}  // namespace fyd::pipeline

/// @cond
extern template FYD_API std::vector<fyd::Parameter> fyd::bindParameters(fyd::pipeline::Parameters& instance);
/// @endcond
