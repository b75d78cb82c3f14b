// A KUKA LWR behind its controller (KRC), as the remote side of FRI 1.0.
//
// Every measurement is answered at once, reflecting its sequence number. Outside command mode the answer mirrors the
// commanded joints plus their offsets, as FRI demands. In command mode, under Cartesian impedance control, it carries
// the target as a frame with stiffness 1000 N/m and 300 Nm/rad and damping 0.3 (thesis §4.2).
//
// Command mode begins (also anew, and after a silence): the frame found there is held and its orientation kept from
// then on; that exchange fails, the next one succeeds and holds, and only what follows moves. The frame found is the
// commanded one, or the measured one where the two lie more than 30 mm apart: what belongs to FRI in the commanded
// frame is not documented well enough to trust it further than the arm yields.
//
// Frame: origin at the tool's commanded place in the first measurement; axes as `axes` maps them. FRI's metres become
// mm. Force: the tool's force along our z, less its mean before command mode (an estimate with an offset), never below
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

#include "core/device/robot.h"
#include "core/protocol/fri_codec.h"
#include "core/protocol/udp_socket.h"

namespace fyd::device {

/// How the touchpad's axes (x right, y back, z up) lie in the robot's base: entry i says along which of our axes base
/// axis i points, 1…3 for x…z, negative for the opposite way.
struct AxisMap {
  std::array<int, 3> base_from_ours{-2, -1, 3};  ///< the authors' X = −y, Y = −x, Z = z; a mirror, as printed

  [[nodiscard]] Vec3 toBase(const Vec3& ours) const;
  [[nodiscard]] Vec3 toOurs(const Vec3& base) const;
};
/// Reads "-y,-x,z". @return an error when it is not three different axes
[[nodiscard]] Result<AxisMap> parseAxisMap(std::string_view text);

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
  std::uint64_t out_of_order = 0;  ///< measurements not newer than the last: answered not
  std::uint64_t wrong_peer = 0;
  std::uint64_t send_failures = 0;
  std::uint64_t command_entries = 0;  ///< times command mode began
  std::array<std::uint64_t, protocol::kFriRefusalCount> refused{};
};

class FriRobot final : public Robot {
 public:
  /// @return an error when the address is taken
  [[nodiscard]] static Result<std::unique_ptr<FriRobot>> open(const FriSettings& settings);

  [[nodiscard]] std::string description() const override;

  /// Answers what has arrived; does not wait. To be called at least as often as the KRC sends.
  /// @return an error that says in words why the arm does not follow: target not finite (nothing is answered with it),
  /// nothing heard, KRC off or in monitor mode, link quality, drive error, another control strategy
  [[nodiscard]] Result<RobotReadings> exchange(const Vec3& target_mm, Instant now) override;

  [[nodiscard]] const protocol::Endpoint& local() const { return socket_.local(); }
  [[nodiscard]] const FriCounters& counters() const { return counters_; }
  /// The newest; nothing before the first.
  [[nodiscard]] const protocol::FriMeasurement* measurement() const { return heard_ ? &newest_ : nullptr; }

 private:
  FriRobot(const FriSettings& settings, protocol::UdpSocket socket);
  bool accept(const protocol::Endpoint& from, Instant now);
  void take(const Vec3& target_mm, Instant now);
  void answer(const Vec3& target_mm);
  void aimAt(const Vec3& target_mm, protocol::FriFrame& frame) const;
  void hold();
  [[nodiscard]] bool mayMove() const;
  [[nodiscard]] RobotReadings readings() const;
  [[nodiscard]] tl::unexpected<Error> reasonNotToFollow(Instant now) const;
  [[nodiscard]] double pressedUp_N() const;
  [[nodiscard]] Vec3 placeOf(const protocol::FriFrame& frame) const;

  FriSettings settings_;
  protocol::UdpSocket socket_;
  std::vector<std::uint8_t> buffer_;
  std::optional<protocol::Endpoint> peer_;
  protocol::FriMeasurement incoming_;
  protocol::FriMeasurement newest_;
  protocol::FriCommand command_;
  bool heard_ = false;
  bool moving_ = false;   // the last answer carried a frame
  bool began_ = false;    // command mode did, in this exchange
  bool holding_ = false;  // it did in the last one
  Instant heard_at_{};
  Vec3 origin_m_;
  protocol::FriFrame held_frame_{};  // commanded when command mode began
  double force_sum_N_ = 0.0;
  int force_count_ = 0;
  FriCounters counters_;
};

}  // namespace fyd::device
