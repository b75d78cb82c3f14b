// The controller's side of FRI 1.0 (KRC of a KUKA LWR) as a simulator: it sends a measurement every period, watches the
// answers, and moves a simulated arm on a material by the commanded frame.
//
// Link quality, from the last 100 measurements' answers (an answer is in time when it reflects the newest measurement
// before the next one is due): perfect from 98 %, good from 90 %, bad from 50 %, else unacceptable. These thresholds
// are assumptions: the real controller's are not documented.
//
// Modes: monitor at first; command after `monitor_for` of good quality; back to monitor when the quality falls below
// good or when the commanded frame jumps (faster than `jump_limit_mm_s`, and more than 1 mm at once); then command again
// after another `monitor_for`. Timed changes of mode override this. In command mode an answer without the flags of
// Cartesian impedance control moves nothing; outside it the joints must mirror the commanded ones plus their offsets.
//
// Geometry: the tool stands at (0.5, 0, 0.3) m of the base and points down; base X = −y, Y = −x, Z = z of the arm
// (the authors' axes). Joints have no kinematics here: their angles are fixed. KRL reals 1…3: accelerometer, g.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stop_token>
#include <vector>

#include "core/base/error.h"
#include "core/protocol/fri_codec.h"
#include "core/protocol/udp_socket.h"
#include "core/sim/robot/robot_arm.h"
#include "core/sim/sim_parameters.h"

namespace fyd::sim {

struct TimedMode {
  double at_s = 0.0;
  protocol::FriState mode = protocol::FriState::monitor;
};

struct KrcOptions {
  protocol::Endpoint remote;  ///< where measurements go
  protocol::Endpoint bind;    ///< own address; port 0: any
  double period_ms = 5.0;     ///< 1…100
  double monitor_for_s = 1.0;
  std::vector<TimedMode> modes;  ///< from then on this mode, whatever the quality
  double jump_limit_mm_s =
      1000.0;  ///< a commanded frame that moves faster, and more than 1 mm at once, ends command mode
  SimParameters arm;
};

struct KrcCounters {
  std::uint64_t measurements = 0;
  std::uint64_t answers = 0;       ///< in time
  std::uint64_t late_answers = 0;  ///< reflecting an older measurement
  std::uint64_t wrong_echoes = 0;  ///< reflecting one that was never sent, or answered already
  std::uint64_t wrong_peer = 0;
  std::uint64_t refused = 0;  ///< datagrams that are no FRI command
  std::uint64_t send_failures = 0;
  std::uint64_t wrong_mirrors = 0;  ///< outside command mode: joints other than the commanded ones
  std::uint64_t wrong_flags = 0;    ///< in command mode: answers without the flags of Cartesian impedance control
  std::uint64_t leaps = 0;
  std::uint64_t command_entries = 0;
  std::uint64_t command_losses = 0;  ///< times command mode ended without a timed change
};

struct KrcStatus {
  protocol::Endpoint local;
  protocol::FriState mode = protocol::FriState::monitor;
  protocol::FriQuality quality = protocol::FriQuality::unacceptable;
  KrcCounters counters;
  double answer_rate = 0.0;  ///< of the last 100, 0…1
  double latency_ms = 0.0;   ///< of the newest answer
  Vec3 position_mm;          ///< of the arm
  double force_N = 0.0;
  double largest_force_N = 0.0;
  double lowest_z_mm = 0.0;
  double fastest_mm_s = 0.0;       ///< of the commanded frame, between two answers
  double travelled_mm = 0.0;       ///< of the commanded frame
  float stiffness_N_per_m = 0.0F;  ///< as commanded, z
  float rotation_stiffness_Nm_per_rad = 0.0F;
  float damping = 0.0F;
  double seconds = 0.0;
};

class Krc {
 public:
  /// @return an error when the address is taken or an option is out of its range
  [[nodiscard]] static Result<std::unique_ptr<Krc>> open(const KrcOptions& options);
  /// Blocks until stopped or `limit` has passed; from one thread, once.
  void run(const std::stop_token& stop, Duration limit = Duration::max());
  /// As of at most 50 ms ago while running; from any thread.
  [[nodiscard]] KrcStatus status() const;
  [[nodiscard]] const protocol::Endpoint& local() const { return socket_.local(); }

 private:
  static constexpr std::size_t kWindow = 100;

  Krc(const KrcOptions& options, protocol::UdpSocket socket);
  void moveArm(Instant now);
  void chooseMode(Instant now);
  void enter(protocol::FriState mode, Instant now);
  void send(Instant now);
  void receiveUntil(Instant deadline);
  void judge(const protocol::FriCommand& command, Instant now);
  void obey(const protocol::FriCommand& command);
  void mark(bool answered);
  void publish(Instant now);

  KrcOptions options_;
  protocol::UdpSocket socket_;
  RobotArm arm_;
  protocol::FriMeasurement measurement_;
  protocol::FriCommand incoming_;
  Vec3 target_mm_;
  bool answered_ = true;  // the newest measurement was
  bool obeyed_ = false;   // a frame, since command mode began
  Instant obeyed_at_{};
  std::array<bool, kWindow> marks_{};  // whether the last measurements were answered
  std::size_t next_mark_ = 0;
  std::size_t next_mode_ = 0;
  bool mode_is_timed_ = false;
  Instant began_{};
  Instant good_since_{};
  Instant sent_at_{};
  Instant published_{};
  std::vector<std::uint8_t> buffer_;
  KrcStatus now_;
  mutable std::mutex mutex_;
  KrcStatus shown_;
};

}  // namespace fyd::sim
