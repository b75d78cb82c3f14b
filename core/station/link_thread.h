// The link thread: owns the socket, answers the robot at once with the newest touch, passes on what it sends.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/latest_value.h"
#include "core/base/ring.h"
#include "core/base/timed.h"
#include "core/device/part_monitor.h"
#include "core/pipeline/inputs.h"
#include "core/protocol/link/link_keys.h"
#include "core/protocol/link_parameters.h"
#include "core/protocol/touchpad_end.h"
#include "core/protocol/udp_socket.h"
#include "core/station/link_status.h"

namespace fyd::station {

/// What the haptic loop sends to the robot.
struct Announcement {
  pipeline::TouchMessage touch;
  Instant taken{};
  double k_vib = 0.0;
  control::MotorCommand motors;
};

/// The latest state values from the robot; its streams go through the rings.
struct LinkSnapshot {
  pipeline::LinkPhase phase = pipeline::LinkPhase::waiting;
  // Each increases even with what was over before the loop read it.
  std::uint64_t losses = 0;    ///< of the link
  std::uint64_t sessions = 0;  ///< begun by a robot
  Timed<pipeline::RobotState> state;
  Timed<pipeline::RobotMotorReference> motor_reference;
  double sample_delay_ms = 0.0;  ///< how long the texture must wait for accelerations; 0: for none (classic)
};

/// How long the texture is to wait for accelerations. A wait that is raised stays, so one late moment must not raise it:
/// the result is the least of what the newest values ask for, in coarse steps, so that small changes of the network's
/// delay are not followed. A value that no heartbeat has renewed is no new evidence: while the robot is silent, the last
/// moment before it would count for a second. And the jitter forgets a late moment within some hundred messages only: with
/// few heartbeats a second the newest values span as many of them, and longer.
class NeededDelay {
 public:
  static constexpr std::size_t kValues = 20;
  static constexpr Duration kPeriod = std::chrono::milliseconds(50);  ///< between two values, at least
  static constexpr std::uint64_t kHeartbeats = 5;                     ///< between two values, at least
  static_assert(kValues * kPeriod == std::chrono::seconds(1));

  /// @param figures whose sample_delay_ms is NaN: unknown, 0 is needed
  /// @return 0 until there have been kValues values
  [[nodiscard]] double add(const protocol::LinkFigures& figures);

 private:
  std::uint64_t heartbeats_ = 0;  ///< at the newest value
  std::array<double, kValues> needed_ms_{};
  std::size_t next_ = 0;
};

/// The phase for one step after the other: a loss and a new session are seen for a step each, also when both were over
/// before the loop read the snapshot. Else a robot that restarts within a cycle would be taken for the one before.
class SeenPhase {
 public:
  [[nodiscard]] pipeline::LinkPhase next(const LinkSnapshot& newest) {
    if (newest.losses != losses_) {
      losses_ = newest.losses;
      return pipeline::LinkPhase::lost;
    }
    if (newest.sessions != sessions_) {
      sessions_ = newest.sessions;
      return pipeline::LinkPhase::waiting;
    }
    return newest.phase;
  }

 private:
  std::uint64_t losses_ = 0;
  std::uint64_t sessions_ = 0;
};

class LinkThread {
 public:
  /// @param key of FYD Link; nothing: the classic protocol, not secured
  /// @param scene digest of the scene that is felt here; empty: none
  /// @return an error when the address is in use or does not exist
  [[nodiscard]] static Result<std::unique_ptr<LinkThread>> open(
      const protocol::Endpoint& local, const protocol::LinkParameters& parameters,
      const std::optional<protocol::LinkKey>& key = std::nullopt, std::string scene = {});
  ~LinkThread();
  /// @param clock_waits everything is simulated: the session's clock waits for this thread
  void start(bool clock_waits = false);
  void shutDown();

  LatestValue<Announcement> announcement;                 ///< written by the haptic loop
  LatestValue<LinkSnapshot> snapshot;                     ///< read by the haptic loop
  Ring<texture::AccelerationSample> accelerations{1024};  ///< read by the haptic loop
  Ring<pipeline::RobotCommand> commands{64};              ///< read by the haptic loop

  /// The camera thread asks this before it spends time on encoding.
  [[nodiscard]] bool wantsImages() const { return wants_images_.load(std::memory_order_relaxed); }
  void offerImage(std::vector<std::uint8_t> encoded);

  [[nodiscard]] const protocol::Endpoint& local() const { return socket_.local(); }
  [[nodiscard]] LinkStatus status() const;
  [[nodiscard]] device::DeviceReport part(Instant now) const;

 private:
  LinkThread(protocol::UdpSocket socket, std::unique_ptr<protocol::TouchpadEnd> end, bool secured, std::string scene);
  [[nodiscard]] protocol::TouchpadAnswer answerFrom(const Announcement& said) const;
  void takeImage();
  void run(const std::stop_token& stop, bool clock_waits);
  void take(const protocol::TouchpadReception& reception, Instant now);
  void send(std::span<const protocol::Datagram> datagrams);
  void publish(Instant now);

  protocol::UdpSocket socket_;
  std::unique_ptr<protocol::TouchpadEnd> end_;
  const bool secured_;
  std::string scene_;
  std::string board_text_;
  LinkSnapshot newest_;
  NeededDelay needed_delay_;
  std::atomic<bool> wants_images_{false};
  std::mutex image_mutex_;
  std::vector<std::uint8_t> offered_image_;
  std::vector<std::uint8_t> image_;  // the link thread's own: the newest that has not been sent
  std::uint64_t lost_samples_ = 0;
  std::uint64_t send_failures_ = 0;
  device::PartMonitor monitor_;
  mutable std::mutex status_mutex_;
  LinkStatus status_;
  std::jthread thread_;
};

}  // namespace fyd::station
