// The link thread: owns the socket, answers the robot at once with the newest touch, passes on what it sends.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/latest_value.h"
#include "core/base/ring.h"
#include "core/device/part_monitor.h"
#include "core/pipeline/inputs.h"
#include "core/protocol/link/link_keys.h"
#include "core/protocol/link_parameters.h"
#include "core/protocol/touchpad_end.h"
#include "core/protocol/udp_socket.h"
#include "core/station/link_snapshot.h"
#include "core/station/link_status.h"

namespace fyd::station {

/// What the haptic loop sends to the robot.
struct Announcement {
  pipeline::TouchMessage touch;
  Instant taken{};
  double k_vib = 0.0;
  control::MotorCommand motors;
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
  std::atomic<bool> wants_images_{false};
  std::mutex image_mutex_;
  std::vector<std::uint8_t> offered_image_;
  std::vector<std::uint8_t> image_;  // the link thread's own
  std::uint64_t lost_samples_ = 0;
  std::uint64_t send_failures_ = 0;
  device::PartMonitor monitor_;
  mutable std::mutex status_mutex_;
  LinkStatus status_;
  std::jthread thread_;
};

}  // namespace fyd::station
