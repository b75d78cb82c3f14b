// The robot of a soak: both ends of a protocol, a network between them that delays, loses, repeats and damages, and a
// simulated arm behind its limits that follows the touches; all in virtual time.
#pragma once

#include <memory>
#include <optional>
#include <queue>
#include <vector>

#include "core/device/robot/following_robot.h"
#include "core/device/robot/touch_reference.h"
#include "core/pipeline/pipeline.h"
#include "core/protocol/link/link_keys.h"
#include "core/protocol/robot_end.h"
#include "core/protocol/touchpad_end.h"
#include "core/sim/network/network_emulator.h"
#include "tests/soak/soak_checks.h"

namespace fyd::soak {

enum class Protocol : std::uint8_t { none, classic, link };

class SoakRobot {
 public:
  SoakRobot(Protocol protocol, int seed);

  /// A millisecond: what came from the robot goes into `inputs`.
  void advance(Instant now, const pipeline::Outputs& outputs, pipeline::Inputs& inputs);

  /// Begins a fault of chance. @return by when Active must have ended, where it must
  std::optional<Deadline> disturb(Chance& chance, Instant now, Figures& figures);
  /// Every fault that it may begin, with a count of 0.
  static void nameFaults(Figures& figures);

  /// What the arm is told, after its limits.
  [[nodiscard]] const Vec3& commanded_mm() const { return arm_->commanded_mm(); }
  /// Whether datagrams arrive with other numbers than were sent: the classic protocol has no check of its own (UDP's would
  /// drop them), so that the arm goes where they say.
  [[nodiscard]] bool misled() const { return protocol_ == Protocol::classic && damaged_share_ > 0.0; }
  /// Of its program, which then stands at a start of its own.
  [[nodiscard]] int starts() const { return starts_; }

 private:
  struct Flight {
    Instant arrival{};
    std::uint64_t number = 0;
    bool to_touchpad = false;
    protocol::Endpoint from;
    std::vector<std::uint8_t> bytes;
    bool operator<(const Flight& other) const {
      return std::pair(arrival, number) > std::pair(other.arrival, other.number);
    }
  };
  void weather(double delay_ms, double jitter_ms, double loss_percent);
  void startRobot();
  void post(std::span<const protocol::Datagram> datagrams, bool to_touchpad, Instant now);
  void deliver(Instant now, pipeline::Inputs& inputs);
  void moveArm(Instant now);

  const Protocol protocol_;
  const int seed_;
  int starts_ = 0;
  std::mt19937_64 random_;
  protocol::LinkKey key_ = protocol::LinkKey::generate();
  std::unique_ptr<protocol::TouchpadEnd> touchpad_;
  std::unique_ptr<protocol::RobotEnd> robot_;
  std::unique_ptr<device::FollowingRobot> arm_;
  std::unique_ptr<device::TouchReference> reference_;
  device::RobotReadings readings_;
  std::optional<sim::NetworkEmulator> there_;
  std::optional<sim::NetworkEmulator> back_;
  std::priority_queue<Flight> flights_;
  std::uint64_t number_ = 0;
  protocol::TouchpadAnswer answer_;
  bool was_lost_ = false;

  double stiffness_N_per_mm_ = 0.62;
  pipeline::RobotMotorReference motor_reference_;
  double damaged_share_ = 0.0;
  bool calm_ = true;
  Instant calm_again_{};
};

}  // namespace fyd::soak
