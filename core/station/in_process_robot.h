// The simulated robot in a thread of this process, connected over real UDP on the loopback interface.
#pragma once

#include <memory>
#include <thread>

#include "core/device/robot/robot_runner.h"
#include "core/protocol/endpoint.h"
#include "core/sim/sim_parameters.h"

namespace fyd::station {

class InProcessRobot {
 public:
  /// @param predictor how it leads its arm; a name that device::followingNamed knows
  /// @param clock_waits everything is simulated: the session's clock waits for this robot
  [[nodiscard]] static Result<std::unique_ptr<InProcessRobot>> open(const protocol::Endpoint& touchpad,
                                                                    const sim::SimParameters& parameters,
                                                                    const std::string& predictor, bool clock_waits);
  ~InProcessRobot() { shutDown(); }
  void start();
  void shutDown();
  [[nodiscard]] device::RobotRunnerStatus status() const { return robot_->status(); }

 private:
  explicit InProcessRobot(std::unique_ptr<device::RobotRunner> robot) : robot_(std::move(robot)) {}

  std::unique_ptr<device::RobotRunner> robot_;
  std::jthread thread_;
};

}  // namespace fyd::station
