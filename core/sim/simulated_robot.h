// The robot end as a runnable: a robot, its stiffness probe, a protocol and a UDP socket, in one loop.
// The console runs it in a thread over loopback; `fyd sim robot` runs it as its own process.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/ring.h"
#include "core/device/material_probe.h"
#include "core/device/robot.h"
#include "core/protocol/classic_robot_end.h"
#include "core/protocol/link_robot_end.h"
#include "core/protocol/touch_mapping.h"
#include "core/protocol/udp_socket.h"

namespace fyd::sim {

struct TimedCommand {
  double at_s = 0.0;  ///< after the first handshake
  pipeline::RobotCommand command = pipeline::RobotCommand::none;
};

struct SimulatedRobotOptions {
  protocol::Endpoint touchpad;  ///< who is called
  protocol::Endpoint bind;      ///< own address; port 0: any
  double rate_Hz = 1000.0;      ///< cycles (classic: states) a second, 1…10 000
  protocol::ClassicRobotSettings link;
  std::optional<protocol::LinkKey> key;  ///< nothing: the classic protocol
  protocol::LinkRobotSettings secure;    ///< with a key: `rate_Hz` is then the accelerometer's
  protocol::TouchMappingSettings mapping;
  device::ProbeSettings probe;
  pipeline::RobotMotorReference motor_reference;  ///< sent after command 10
  std::vector<TimedCommand> commands;             ///< in the order of their times
  /// Longest wait for the reply to the goodbye that a stop says; zero: stops without a word.
  Duration farewell = std::chrono::milliseconds(100);
};

struct SimulatedRobotStatus {
  std::string description;
  protocol::Endpoint local;
  protocol::RobotPhase phase = protocol::RobotPhase::handshake;
  protocol::RobotCounters counters;
  std::string_view problem;  ///< why there is no session
  device::ProbeOutcome probe_outcome = device::ProbeOutcome::aborted;
  double probed_stiffness_N_per_mm = 0.0;
  device::RobotReadings readings;
  pipeline::TouchMessage touch;     ///< the newest
  std::uint64_t connections = 0;    ///< handshakes completed
  std::uint64_t missed_cycles = 0;  ///< of the loop's own clock
  std::uint64_t robot_errors = 0;   ///< exchanges with the arm that failed
  std::uint64_t send_failures = 0;  ///< datagrams the network did not take
  std::uint64_t commands_lost = 0;  ///< asked for while sixteen were waiting
  double seconds = 0.0;             ///< since `run` began
};

class SimulatedRobot {
 public:
  /// Binds the socket and probes the material, in the arm's own virtual time (the arm must be a simulated one).
  /// @return an error when the address is taken or an option is out of its range
  [[nodiscard]] static Result<std::unique_ptr<SimulatedRobot>> open(const SimulatedRobotOptions& options,
                                                                    std::unique_ptr<device::Robot> robot);

  /// Connects, exchanges, reconnects when the touchpad went away and returns; until stopped, until `limit` has
  /// passed, or until a command 9 of the robot's own has closed the session. Blocks; call from one thread, once.
  void run(const std::stop_token& stop, Duration limit = Duration::max());

  /// For the robot's operator; from one other thread. @return false when sixteen commands are waiting
  bool command(pipeline::RobotCommand command);
  /// As of at most 50 ms ago while running; from any thread.
  [[nodiscard]] SimulatedRobotStatus status() const;
  [[nodiscard]] const protocol::Endpoint& local() const { return socket_.local(); }

 private:
  SimulatedRobot(const SimulatedRobotOptions& options, std::unique_ptr<device::Robot> robot,
                 protocol::UdpSocket socket);
  void probe();
  void exchangeWithRobot(Instant now);
  void sendDue(Instant now);
  void receiveUntil(Instant deadline);
  void queueCommands(Instant now);
  void sayFarewell();
  void publish(Instant now);

  SimulatedRobotOptions options_;
  std::unique_ptr<device::Robot> robot_;
  protocol::UdpSocket socket_;
  std::unique_ptr<protocol::RobotEnd> end_;
  protocol::TouchMapping mapping_;
  std::vector<std::uint8_t> buffer_;
  Ring<pipeline::RobotCommand> asked_{16};
  std::size_t next_command_ = 0;
  Vec3 rest_acceleration_g_;
  Instant began_{};
  Instant published_{};
  Instant connected_{};
  SimulatedRobotStatus now_;  // the loop's own
  mutable std::mutex mutex_;
  SimulatedRobotStatus shown_;
};

}  // namespace fyd::sim
