// The robot end as a runnable [thesis §4.2]: an arm behind the motion limits, its preparation (material probe, rest
// acceleration), the mapping of touches to motion, one end of a protocol and a UDP socket, in one loop. Any arm, real
// or simulated; the classic protocol, or FYD Link with a key.
// The console runs it in a thread over loopback; `fyd robot` and `fyd sim robot` run it as their own process.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/ring.h"
#include "core/device/robot/following_robot.h"
#include "core/device/robot/material_probe.h"
#include "core/device/robot/robot.h"
#include "core/device/robot/robot_preparation.h"
#include "core/device/robot/touch_reference.h"
#include "core/protocol/classic/classic_robot_end.h"
#include "core/protocol/link/link_robot_end.h"
#include "core/protocol/udp_socket.h"

namespace fyd::device {

struct TimedCommand {
  double at_s = 0.0;  ///< after the first handshake
  pipeline::RobotCommand command = pipeline::RobotCommand::none;
};

struct RobotRunnerOptions {
  protocol::Endpoint touchpad;           ///< the end to connect to
  protocol::Endpoint bind;               ///< own address; port 0: any
  double rate_Hz = 1000.0;               ///< cycles (classic: states) a second, 1…10 000
  protocol::ClassicRobotSettings link;   ///< of the classic protocol
  std::optional<protocol::LinkKey> key;  ///< nothing: the classic protocol
  protocol::LinkRobotSettings secure;    ///< with a key: `rate_Hz` is then the accelerometer's
  TouchReferenceSettings reference;
  ProbeSettings probe;
  pipeline::RobotMotorReference motor_reference;  ///< sent after command 10
  std::vector<TimedCommand> commands;             ///< in the order of their times
  /// Longest wait for the reply to the closing message that a stop sends; zero: a stop sends none.
  Duration farewell = std::chrono::milliseconds(100);
  MotionLimits limits;
  bool probe_material = true;
  bool clock_waits = false;               ///< everything is simulated: the session's clock waits for this loop
  double known_stiffness_N_per_mm = 0.0;  ///< sent to the touchpad when the material is not probed
};

struct RobotRunnerStatus {
  Message description;
  protocol::Endpoint local;
  protocol::RobotPhase phase = protocol::RobotPhase::handshake;
  protocol::RobotCounters counters;
  std::string touchpad;      ///< the touchpad's own description; empty: none
  std::string_view problem;  ///< why there is no session
  bool prepared = false;     ///< the probe's result is known
  ProbeOutcome probe_outcome = ProbeOutcome::skipped;
  double probed_stiffness_N_per_mm = 0.0;
  RobotReadings readings;
  pipeline::TouchMessage touch;  ///< the newest
  Vec3 arrived_mm;               ///< position that `touch` maps to, without prediction
  Vec3 target_mm;                ///< the arm's target
  ReferenceFigures reference;
  std::uint64_t connections = 0;      ///< handshakes completed
  std::uint64_t missed_cycles = 0;    ///< of the loop's own clock
  std::uint64_t robot_errors = 0;     ///< exchanges with the arm that failed
  std::uint64_t robot_resumed = 0;    ///< times the arm followed again after that
  Message robot_problem;              ///< why the last exchange failed; empty: it did not
  std::uint64_t send_failures = 0;    ///< datagrams the network did not take
  std::uint64_t commands_lost = 0;    ///< asked for while sixteen were waiting
  std::uint64_t targets_refused = 0;  ///< targets that were not finite
  double seconds = 0.0;               ///< since `run` began
};

class RobotRunner {
 public:
  /// Binds the socket. An arm in virtual time is prepared at once, any other one when `run` begins.
  /// @return an error when the address is taken or an option is out of its range
  [[nodiscard]] static Result<std::unique_ptr<RobotRunner>> open(const RobotRunnerOptions& options,
                                                                 std::unique_ptr<Robot> robot);

  /// Prepares, connects, exchanges, reconnects when the touchpad went away and returns; until stopped, until `limit`
  /// has passed, or until a command 9 of the robot's own has closed the session. At a stop, a running probe first goes
  /// back to its start, and a moving arm brakes within its limits. While the arm does not follow, the touchpad is told
  /// nothing but a goodbye: old readings would look like new ones. Blocks; call from one thread, once.
  void run(const std::stop_token& stop, Duration limit = Duration::max());

  /// For the robot's operator; from one other thread. @return false when sixteen commands are waiting
  bool command(pipeline::RobotCommand command);
  /// As of at most 50 ms ago while running; from any thread.
  [[nodiscard]] RobotRunnerStatus status() const;
  [[nodiscard]] const protocol::Endpoint& local() const { return socket_.local(); }

 private:
  RobotRunner(const RobotRunnerOptions& options, std::unique_ptr<Robot> robot, protocol::UdpSocket socket);
  void prepareAhead();
  void prepareStep(Duration tick, Instant now);
  void exchangeWithRobot(const MovingTarget& target, Duration tick, Instant now);
  void sendDue(Instant now);
  void receiveUntil(Instant deadline);
  void queueCommands(Instant now);
  [[nodiscard]] bool queue(pipeline::RobotCommand command);
  void sayFarewell();
  void publish(Instant now);

  RobotRunnerOptions options_;
  FollowingRobot robot_;
  std::unique_ptr<protocol::RobotEnd> end_;
  protocol::UdpSocket socket_;
  RobotPreparation preparation_;
  TouchReference reference_;
  std::vector<std::uint8_t> buffer_;
  Ring<pipeline::RobotCommand> asked_{16};
  std::size_t next_command_ = 0;
  bool leaving_ = false;  // a goodbye is to be said, whatever the arm does
  Instant began_{};
  Instant published_{};
  Instant connected_{};
  RobotRunnerStatus now_;  // used by the loop only
  mutable std::mutex mutex_;
  RobotRunnerStatus shown_;
};

}  // namespace fyd::device
