// A UDP relay that delays and drops datagrams as a network would (network_emulator.h), between any two processes,
// without root rights: callers send to the relay instead of to the called side, which sees each caller as one of the
// relay's own addresses. Answers leave from the address that was called, as protocols that check their peer demand.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <queue>
#include <stop_token>
#include <vector>

#include "core/base/error.h"
#include "core/protocol/udp_socket.h"
#include "core/sim/network/network_emulator.h"

namespace fyd::sim {

struct NetworkRelayOptions {
  protocol::Endpoint listen;   ///< what the callers call
  protocol::Endpoint forward;  ///< the called side
  NetworkProfile path;         ///< each caller has a path of its own, seeded alike
};

struct DirectionStatistics {
  std::uint64_t received = 0;
  std::uint64_t delivered = 0;  ///< copies included
  std::uint64_t lost = 0;
  std::uint64_t queue_full = 0;
  std::uint64_t reordered = 0;
  std::uint64_t duplicated = 0;
  std::uint64_t bytes = 0;  ///< received
  std::uint64_t send_failures = 0;
  double delay_ms_mean = 0.0;  ///< measured, from reception to delivery
  double delay_ms_min = 0.0;
  double delay_ms_max = 0.0;
  double late_ms_max = 0.0;  ///< largest lag of a delivery behind the emulator's time: the relay's own error
};

struct NetworkRelayStatus {
  protocol::Endpoint listen;
  DirectionStatistics forward;
  DirectionStatistics backward;
  std::uint64_t callers = 0;
  std::uint64_t callers_refused = 0;  ///< datagrams of callers beyond the sixteenth, or for whom there was no socket
  Message no_socket;                  ///< why there was none for the last such caller; empty: there always was one
  std::uint64_t wrong_peer = 0;       ///< answers from another address than the called side's
  double seconds = 0.0;
};

class NetworkRelay {
 public:
  static constexpr std::size_t kMaximumCallers = 16;
  static constexpr std::size_t kMaximumUnderway = 20'000;  ///< datagrams; more are dropped as queue_full

  /// @return an error when the address is taken or a setting is out of its range
  [[nodiscard]] static Result<std::unique_ptr<NetworkRelay>> open(const NetworkRelayOptions& options);
  /// Blocks until stopped or `limit` has passed; from one thread, once.
  void run(const std::stop_token& stop, Duration limit = Duration::max());
  /// As of at most 50 ms ago while running; from any thread.
  [[nodiscard]] NetworkRelayStatus status() const;
  [[nodiscard]] const protocol::Endpoint& local() const { return listen_.local(); }

 private:
  struct Caller {
    protocol::Endpoint address;
    protocol::UdpSocket socket;  // towards the called side
    NetworkEmulator forward;
    NetworkEmulator backward;
  };
  struct Underway {
    Instant due{};
    std::uint64_t order = 0;  // of equally due ones
    Instant taken{};
    std::size_t caller = 0;
    bool is_forward = true;
    std::vector<std::uint8_t> bytes;
  };
  struct Later {
    bool operator()(const Underway& a, const Underway& b) const {
      return a.due != b.due ? a.due > b.due : a.order > b.order;
    }
  };

  NetworkRelay(const NetworkRelayOptions& options, protocol::UdpSocket listen);
  void takeCalls();
  void takeAnswers(std::size_t caller);
  /// The caller's index, added when new; the number of callers when no more can be added.
  std::size_t callerOf(const protocol::Endpoint& from);
  void put(std::size_t caller, bool is_forward, std::size_t size, Instant now);
  void deliver(Instant now);
  void publish(Instant now);

  NetworkRelayOptions options_;
  protocol::UdpSocket listen_;
  std::vector<Caller> callers_;
  std::vector<const protocol::UdpSocket*> waited_for_;
  std::priority_queue<Underway, std::vector<Underway>, Later> underway_;
  std::uint64_t order_ = 0;
  std::vector<std::uint8_t> buffer_;
  Instant began_{};
  Instant published_{};
  NetworkRelayStatus now_;
  mutable std::mutex mutex_;
  NetworkRelayStatus shown_;
};

}  // namespace fyd::sim
