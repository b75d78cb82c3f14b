// A KUKA LWR behind its controller (KRC), as the remote side of FRI 1.0.
//
// Every measurement is answered at once, reflecting its sequence number. Outside command mode the answer mirrors the
// commanded joints plus their offsets, as FRI demands. In command mode, under Cartesian impedance control, it carries
// a frame with stiffness 1000 N/m and 300 Nm/rad and damping 0.3 [thesis §4.2].
//
// Limits: each answer is one command, for one tick of the controller (fri_tick.h), so the motion to the target advances
// by one tick for each answer, independent of this machine's clock. It goes on from the controller's commanded
// position: when the last answer does not show in the commanded frame, or a sequence number is missing, a tick passed
// without a command and the arm stood still in it; the motion then starts anew there, from rest. Of several
// measurements that wait, the older ones are answered with a halt: their ticks are over. When the link quality drops
// while the controller still obeys, the arm brakes within the limits.
//
// Implausible measurements (fri_check.h) are refused: neither used nor answered.
//
// When command mode begins (also anew, and after a silence), the present frame is held and its orientation kept from
// then on; that exchange fails, the next one succeeds and holds, and only later ones move the arm. The present frame is
// the commanded one, or the measured one where the two are more than 30 mm apart: FRI's part of the commanded frame is
// not documented well enough to trust it beyond the arm's compliance.
//
// Frame: origin at the tool's commanded place in the first measurement; axes as `axes` maps them. FRI's metres become
// mm. Force: the tool's force along z, less its mean before command mode (an estimate with an offset), never below
// 0. FRI carries no accelerometer: KRL reals 1…3 are taken as x, y, z in g, which the program on the KRC may fill from
// its analogue inputs; 0 when it does not.
//
// One controller: the first that sends a valid measurement, until it was silent for a second. FRI has no
// authentication: the cable to the KRC is a network of its own.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/device/robot/axis_map.h"
#include "core/device/robot/fri_tick.h"
#include "core/device/robot/robot.h"
#include "core/protocol/fri_codec.h"
#include "core/protocol/udp_socket.h"

namespace fyd::device {

struct FriSettings {
  protocol::Endpoint bind;                ///< where the KRC sends to; port kFriPort on a real one
  std::optional<protocol::Endpoint> krc;  ///< accepts measurements from this host only; its port is not compared
  AxisMap axes;
  float stiffness_N_per_m = 1000.0F;
  float rotation_stiffness_Nm_per_rad = 300.0F;
  float damping = 0.3F;
  Duration silence = std::chrono::milliseconds(250);  ///< of the KRC, from which an exchange fails
};

struct FriCounters {
  std::uint64_t measurements = 0;
  std::uint64_t answers = 0;
  std::uint64_t out_of_order = 0;  ///< measurements not newer than the last: not answered
  std::uint64_t wrong_peer = 0;
  std::uint64_t send_failures = 0;
  std::uint64_t command_entries = 0;  ///< times command mode began
  std::uint64_t not_taken = 0;        ///< answers in command mode that the controller did not take in their tick
  std::uint64_t impossible = 0;       ///< implausible measurements: not answered
  std::array<std::uint64_t, protocol::kFriRefusalCount> refused{};
};

class FriRobot final : public Robot {
 public:
  /// @return an error when the address is taken
  [[nodiscard]] static Result<std::unique_ptr<FriRobot>> open(const FriSettings& settings);

  [[nodiscard]] Message description() const override;

  /// Answers what has arrived; does not wait. To be called at least as often as the KRC sends.
  /// @return an error that says why the arm does not follow: target not finite (nothing is answered with it),
  /// nothing heard, an impossible measurement, KRC off or in monitor mode, link quality, drive error, another control
  /// strategy
  [[nodiscard]] Result<RobotReadings> exchange(const Vec3& target_mm, Instant now) override;
  bool keepLimits(const MotionLimits& limits) override;
  void comeToRest() override { stopping_ = true; }
  void targetMoves(const Vec3& velocity_mm_s) override { velocity_mm_s_ = velocity_mm_s; }
  [[nodiscard]] bool atRest() const override { return !moving_ || limiter_.atRest(); }

  [[nodiscard]] const protocol::Endpoint& local() const { return socket_.local(); }
  [[nodiscard]] const FriCounters& counters() const { return counters_; }
  /// The newest; nothing before the first.
  [[nodiscard]] const protocol::FriMeasurement* measurement() const { return heard_ ? &newest_ : nullptr; }

 private:
  FriRobot(const FriSettings& settings, protocol::UdpSocket socket);
  bool accept(const protocol::Endpoint& from, Instant now);
  void receive(const std::optional<Vec3>& target_mm, Instant now);
  void take(int ahead, Instant now);
  void answer(const std::optional<Vec3>& target_mm, bool in_time);
  void move(const std::optional<Vec3>& target_mm, bool in_time);
  void compareWithSent(int ahead);
  void hold();
  void aimAt(const Vec3& place_mm);
  [[nodiscard]] bool obeys() const;
  [[nodiscard]] bool follows(Instant now) const;
  [[nodiscard]] RobotReadings readings() const;
  [[nodiscard]] tl::unexpected<Error> reasonNotToFollow(Instant now) const;
  [[nodiscard]] double pressedUp_N() const;
  [[nodiscard]] Vec3 placeOf(const Vec3& base_m) const;

  FriSettings settings_;
  protocol::UdpSocket socket_;
  std::vector<std::uint8_t> buffer_;
  std::optional<protocol::Endpoint> peer_;
  protocol::FriMeasurement incoming_;
  protocol::FriMeasurement newest_;
  protocol::FriCommand command_;
  Message impossible_;  // why the newest measurement was refused; empty: it was not
  Instant impossible_at_{};
  FriTick tick_;
  MotionLimiter limiter_;
  Vec3 velocity_mm_s_;  // of the target
  bool heard_ = false;
  bool moving_ = false;    // the last answer carried a frame
  bool began_ = false;     // command mode began in this exchange
  bool followed_ = false;  // the last exchange succeeded: the caller knows where the arm stands
  bool stopping_ = false;
  int not_taken_in_a_row_ = 0;  // answers that would have moved the arm
  Vec3 stood_m_;                // last commanded place that the controller reported
  std::optional<bool> in_offset_;
  Instant heard_at_{};
  Vec3 origin_m_;
  protocol::FriFrame held_frame_{};  // commanded when command mode began
  double force_sum_N_ = 0.0;
  int force_count_ = 0;
  FriCounters counters_;
};

}  // namespace fyd::device
