// What `fyd robot` and `fyd sim robot` share: the options of a robot end, its run and its summary.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/parts/command.h"
#include "core/device/robot/robot_runner.h"

namespace fyd::cli {

struct EndOptions {
  std::string connect;
  std::string bind = "127.0.0.2:3490";
  double duration_s = 0.0;
  double rate_Hz = 1000.0;
  std::vector<std::string> commands;
  std::string motor_reference = "0,0";
  std::string waits = "modern";
  bool link = false;
  std::string key;
  double state_rate_Hz = 100.0;
  bool json = false;
};

void addEndOptions(CLI::App& command, EndOptions& options);

/// @param name of the robot end over FYD Link; static storage
[[nodiscard]] device::RobotRunnerOptions runnerOptions(const EndOptions& options, std::string_view name);

/// Runs until Ctrl-C, the duration's end or the robot's own end, reports events on standard error, and prints the
/// summary. Failure when no touchpad answered.
/// @param arm_summary called at the end; what it gives stands under "arm", unless null
void runRobotEnd(const EndOptions& given, const device::RobotRunnerOptions& options, std::unique_ptr<device::Robot> arm,
                 const std::function<nlohmann::ordered_json()>& arm_summary);

}  // namespace fyd::cli
