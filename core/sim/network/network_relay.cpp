#include "core/sim/network/network_relay.h"

#include <algorithm>
#include <utility>

namespace fyd::sim {
namespace {

constexpr Duration kRelayPublishesEvery = std::chrono::milliseconds(50);
constexpr Duration kLongestWait = std::chrono::milliseconds(20);  // until the next check for a stop
constexpr int kMostAtOnce = 64;

}  // namespace

Result<std::unique_ptr<NetworkRelay>> NetworkRelay::open(const NetworkRelayOptions& options) {
  if (options.forward.port == 0) {
    return fail("relay: the called side's address {} has no port", protocol::toString(options.forward));
  }
  for (const NetworkSettings* direction : {&options.path.forward, &options.path.backward}) {
    if (auto good = checkNetwork(*direction); !good) return tl::unexpected(good.error());
  }
  auto listen = protocol::UdpSocket::open(options.listen);
  if (!listen) return tl::unexpected(listen.error());
  if (options.forward == options.listen) {
    return fail("relay: {} stands on both sides; expected two addresses", protocol::toString(options.listen));
  }
  return std::unique_ptr<NetworkRelay>(new NetworkRelay(options, std::move(*listen)));
}

NetworkRelay::NetworkRelay(const NetworkRelayOptions& options, protocol::UdpSocket listen)
    : options_(options), listen_(std::move(listen)), buffer_(protocol::kMaximumDatagram) {
  callers_.reserve(kMaximumCallers);
  waited_for_.push_back(&listen_);
  now_.listen = listen_.local();
  shown_ = now_;
}

void NetworkRelay::run(const std::stop_token& stop, Duration limit) {
  began_ = Clock::now();
  for (Instant now = began_; !stop.stop_requested() && now - began_ < limit; now = Clock::now()) {
    deliver(now);
    if (now - published_ >= kRelayPublishesEvery) publish(now);
    const Instant until = now + kLongestWait;
    protocol::waitForAny(waited_for_, underway_.empty() ? kLongestWait : std::min(underway_.top().due, until) - now);
    takeCalls();
    for (std::size_t i = 0; i < callers_.size(); ++i) takeAnswers(i);
  }
  publish(Clock::now());
}

NetworkRelayStatus NetworkRelay::status() const {
  const std::lock_guard lock(mutex_);
  return shown_;
}

void NetworkRelay::takeCalls() {
  for (int i = 0; i < kMostAtOnce; ++i) {
    const auto received = listen_.receive(buffer_, Duration::zero());
    if (!received) return;
    const auto caller = callerOf(received->from);
    if (caller == callers_.size()) {
      ++now_.callers_refused;
    } else {
      put(caller, true, received->size, Clock::now());
    }
  }
}

void NetworkRelay::takeAnswers(std::size_t caller) {
  for (int i = 0; i < kMostAtOnce; ++i) {
    const auto received = callers_[caller].socket.receive(buffer_, Duration::zero());
    if (!received) return;
    if (received->from == options_.forward) {
      put(caller, false, received->size, Clock::now());
    } else {
      ++now_.wrong_peer;
    }
  }
}

std::size_t NetworkRelay::callerOf(const protocol::Endpoint& from) {
  const auto known = std::ranges::find(callers_, from, &Caller::address);
  if (known != callers_.end() || callers_.size() == kMaximumCallers) {
    return static_cast<std::size_t>(known - callers_.begin());
  }
  protocol::Endpoint any_port = options_.forward.v6 == options_.listen.v6 ? options_.listen : protocol::Endpoint{};
  any_port.v6 = options_.forward.v6;
  any_port.port = 0;
  auto socket = protocol::UdpSocket::open(any_port);
  if (!socket) {
    now_.no_socket = socket.error().message;
    return callers_.size();
  }
  callers_.push_back({.address = from,
                      .socket = std::move(*socket),
                      .forward = NetworkEmulator(options_.path.forward),
                      .backward = NetworkEmulator(options_.path.backward)});
  waited_for_.push_back(&callers_.back().socket);
  now_.callers = callers_.size();
  return callers_.size() - 1;
}

void NetworkRelay::put(std::size_t caller, bool is_forward, std::size_t size, Instant now) {
  DirectionStatistics& statistics = is_forward ? now_.forward : now_.backward;
  ++statistics.received;
  statistics.bytes += size;
  const Passage passage = (is_forward ? callers_[caller].forward : callers_[caller].backward).pass(size, now);
  statistics.lost += passage.fate == DatagramFate::lost ? 1 : 0;
  const bool room = underway_.size() + passage.out.size() <= kMaximumUnderway;
  statistics.queue_full += passage.fate == DatagramFate::queue_full || !room ? 1 : 0;
  if (passage.fate != DatagramFate::passed || !room) return;
  statistics.reordered += passage.reordered ? 1 : 0;
  statistics.duplicated += passage.out.size() - 1;
  for (const Instant due : passage.out) {
    underway_.push({.due = due,
                    .order = order_++,
                    .taken = now,
                    .caller = caller,
                    .is_forward = is_forward,
                    .bytes = {buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(size)}});
  }
}

void NetworkRelay::deliver(Instant now) {
  for (; !underway_.empty() && underway_.top().due <= now; underway_.pop()) {
    const Underway& next = underway_.top();
    Caller& caller = callers_[next.caller];
    DirectionStatistics& statistics = next.is_forward ? now_.forward : now_.backward;
    const auto outcome =
        next.is_forward ? caller.socket.send(next.bytes, options_.forward) : listen_.send(next.bytes, caller.address);
    if (outcome != protocol::SendOutcome::sent) {
      ++statistics.send_failures;
      continue;
    }
    const double delay_ms = toMilliseconds(now - next.taken);
    ++statistics.delivered;
    statistics.delay_ms_mean += (delay_ms - statistics.delay_ms_mean) / static_cast<double>(statistics.delivered);
    statistics.delay_ms_min = statistics.delivered == 1 ? delay_ms : std::min(statistics.delay_ms_min, delay_ms);
    statistics.delay_ms_max = std::max(statistics.delay_ms_max, delay_ms);
    statistics.late_ms_max = std::max(statistics.late_ms_max, toMilliseconds(now - next.due));
  }
}

void NetworkRelay::publish(Instant now) {
  published_ = now;
  now_.seconds = toSeconds(now - began_);
  const std::lock_guard lock(mutex_);
  shown_ = now_;
}

}  // namespace fyd::sim
