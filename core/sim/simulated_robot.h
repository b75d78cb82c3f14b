// The robot end with a simulated arm: device::RobotRunner, whose preparation then takes no time (the arm must be one in
// virtual time). The console runs it in a thread over loopback; `fyd sim robot` runs it as its own process.
#pragma once

#include "core/device/robot_runner.h"

namespace fyd::sim {

using TimedCommand = device::TimedCommand;
using SimulatedRobotOptions = device::RobotRunnerOptions;
using SimulatedRobotStatus = device::RobotRunnerStatus;
using SimulatedRobot = device::RobotRunner;

}  // namespace fyd::sim
