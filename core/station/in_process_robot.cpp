#include "core/station/in_process_robot.h"

#include "core/sim/robot/robot_arm.h"
#include "core/station/real_time.h"

namespace fyd::station {

Result<std::unique_ptr<InProcessRobot>> InProcessRobot::open(const protocol::Endpoint& touchpad,
                                                             const sim::SimParameters& parameters,
                                                             const std::string& predictor, bool clock_waits) {
  auto any_port = protocol::parseEndpoint("127.0.0.1:0");
  device::RobotRunnerOptions options;
  options.touchpad = touchpad;
  options.bind = *any_port;
  options.clock_waits = clock_waits;
  const auto following = device::followingNamed(predictor);
  if (!following) return tl::unexpected(following.error());
  options.reference.predictor = *following;
  auto robot = device::RobotRunner::open(options, std::make_unique<sim::RobotArm>(parameters));
  if (!robot) return tl::unexpected(robot.error());
  return std::unique_ptr<InProcessRobot>(new InProcessRobot(std::move(*robot)));
}

void InProcessRobot::start() {
  thread_ = std::jthread([this](const std::stop_token& stop) {
    askForRealTime(Urgency::robot);
    robot_->run(stop);
  });
}

void InProcessRobot::shutDown() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
}

}  // namespace fyd::station
