// The simulated robot, or a scene in its place, in a thread of this process, connected over real UDP on the loopback
// interface.
#pragma once

#include <memory>
#include <thread>

#include "core/protocol/endpoint.h"
#include "core/sim/sim_parameters.h"
#include "core/sim/simulated_robot.h"
#include "core/station/robot_choice.h"

namespace fyd::sim {
class SceneStage;
}

namespace fyd::station {

class InProcessRobot {
 public:
  /// An arm probes its material before it connects; a scene knows what it is made of.
  [[nodiscard]] static Result<std::unique_ptr<InProcessRobot>> open(const protocol::Endpoint& touchpad,
                                                                    const sim::SimParameters& parameters,
                                                                    const RobotChoice& choice);
  ~InProcessRobot() { shutDown(); }
  void start();
  void shutDown();
  [[nodiscard]] sim::SimulatedRobotStatus status() const { return robot_->status(); }
  /// Null of an arm.
  [[nodiscard]] const std::shared_ptr<sim::SceneStage>& scene() const { return scene_; }

 private:
  InProcessRobot(std::unique_ptr<sim::SimulatedRobot> robot, std::shared_ptr<sim::SceneStage> scene)
      : robot_(std::move(robot)), scene_(std::move(scene)) {}

  std::unique_ptr<sim::SimulatedRobot> robot_;
  std::shared_ptr<sim::SceneStage> scene_;
  std::jthread thread_;
};

}  // namespace fyd::station
