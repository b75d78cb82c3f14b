// The faults: what may be missing or go wrong, one line each, the most urgent first: of several, the first is shown.
// Included several times, each time with another definition of FAULT, as in safety.h: no
// #pragma once.
//
//   FAULT(name, number, need, of, help, what, remedy, missing)
//
//   number   stored in files: it never changes, and a new line takes the next free number, wherever it stands
//   need     when it is needed (Need)
//   of       line of the readiness list that it belongs to (Part)
//   help     page of the window that helps to remove it (Help)
//   what     what is wrong, as a phrase
//   remedy   what the operator does about it, as a sentence
//   missing  the condition, from the step's `in` (inputs), `limits` (its parameters) and `now` (HealthContext);
//            `stays` tolerates a bad value for so many milliseconds once it has been good
// Stability: stable since 0.1

// clang-format off
FAULT(step_gap, 1, rendering, none, none, sentence("the haptic loop stood still for more than 20 ms"),
     sentence("Close other programs on this machine."), now.step_gap)
FAULT(steps_missed, 2, rendering, none, none, sentence("more than 5 % of the haptic cycles of one second were missed"),
     sentence("Close other programs on this machine."), now.steps_missed)
FAULT(motors_stale, 3, always, motors, devices, sentence("the motors are silent"),
     sentence("Check the touchpad's power and its cable."), stale(in.motors, limits.motors_maximum_age_ms))
FAULT(ir_stale, 4, always, distances, devices, sentence("the distance sensors are silent"),
     sentence("Check the touchpad's power and cables."), stale(in.ir, limits.ir_maximum_age_ms))
FAULT(ir_invalid, 5, always, distances, signal, sentence("too few distance sensors read within their span"),
     sentence("Look for dirt or an object under the cloth; calibrate."),
     !stale(in.ir, limits.ir_maximum_age_ms) &&
       stays(Fault::ir_invalid, !now.indentation_usable, limits.ir_maximum_age_ms))
FAULT(bridge_stale, 6, always, load_cell, devices, sentence("the load cell is silent"),
     sentence("Check the load cell's bridge and its cable."), stale(in.bridge, limits.bridge_maximum_age_ms))
FAULT(bridge_invalid, 7, always, load_cell, signal, sentence("the load cell's value is outside its span"),
     sentence("Take the load off the cover; check the bridge's wiring."),
     !stale(in.bridge, limits.bridge_maximum_age_ms) &&
       stays(Fault::bridge_invalid, !now.bridge_valid, limits.bridge_maximum_age_ms))
FAULT(camera_stale, 8, always, camera, devices, sentence("the camera sends no pictures"),
     sentence("Check the camera's cable or choose another source."), stale(in.finger, limits.finger_maximum_age_ms))
FAULT(camera_blind, 9, always, camera, signal,
     sentence("the camera sees nothing: picture black, white, of one grey, empty or in an unknown light"),
     sentence("Check light and lens cap."),
     !stale(in.finger, limits.finger_maximum_age_ms) &&
       stays(Fault::camera_blind, !showsCloth(in.finger.value.reason), limits.finger_maximum_age_ms))
FAULT(robot_waiting, 10, robot, robot, link, sentence("no robot has connected"),
     sentence("Start the robot's program, or set the target by hand."),
     in.robot.phase == LinkPhase::none || in.robot.phase == LinkPhase::waiting)
FAULT(robot_lost, 11, robot, robot, link, sentence("the robot is silent"),
     sentence("Check the network and the robot's program."), in.robot.phase == LinkPhase::lost)
FAULT(robot_closed, 12, robot, robot, link, sentence("the robot has said goodbye"),
     sentence("Start the robot's program again."), in.robot.phase == LinkPhase::closed)
FAULT(robot_frozen, 13, robot, robot, link, sentence("the robot's stiffness is not a number"),
     sentence("Check the robot's force sensor and probe again."),
     in.robot.state.count > 0 && !std::isfinite(in.robot.state.value.stiffness_N_per_mm))
FAULT(no_target, 14, always, target, target, sentence("no stiffness target"),
     sentence("Choose the robot's stiffness or set one by hand."), !now.target_known)
FAULT(operator_silent, 15, rendering, none, none, sentence("the window did not answer for half a second"),
     sentence("Wait until it answers; close other programs on this machine."), false /* set by a command */)
// clang-format on
