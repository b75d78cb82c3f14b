// The relay between real sockets: both directions, several clients, and its counters.
#include "core/sim/network/network_relay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tests/no_free_file.h"
#include "tests/wait.h"

namespace fyd::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

protocol::UdpSocket socketAt(const char* text) {
  return protocol::UdpSocket::open(protocol::parseEndpoint(text).value()).value();
}

class RelayTest : public ::testing::Test {
 protected:
  void start(const NetworkSettings& settings) {
    relay = NetworkRelay::open({.listen = protocol::parseEndpoint("127.0.0.1:0").value(),
                                .forward = called.local(),
                                .path = {.forward = settings, .backward = settings}})
                .value();
    thread = std::jthread([this](const std::stop_token& stop) { relay->run(stop); });
  }
  void stop() {
    thread.request_stop();
    thread.join();
  }
  std::optional<protocol::UdpSocket::Received> receive(protocol::UdpSocket& socket, Duration timeout = kPatience) {
    return socket.receive(buffer, timeout);
  }
  static std::vector<std::uint8_t> text(const std::string& bytes) { return {bytes.begin(), bytes.end()}; }

  std::array<std::uint8_t, 2000> buffer{};
  protocol::UdpSocket called = socketAt("127.0.0.1:0");
  std::unique_ptr<NetworkRelay> relay;
  std::jthread thread;
};

TEST_F(RelayTest, AnswersReachEachCallerFromTheAddressItCalled) {
  start({});
  auto one = socketAt("127.0.0.2:0");
  auto two = socketAt("127.0.0.3:0");
  std::vector<protocol::Endpoint> seen;
  for (auto* caller : {&one, &two}) {
    static_cast<void>(caller->send(text("hello"), relay->local()));
    const auto got = receive(called);
    ASSERT_TRUE(got);
    EXPECT_EQ(got->size, 5U);
    seen.push_back(got->from);
  }
  EXPECT_FALSE(seen[0] == seen[1]);
  static_cast<void>(called.send(text("to two"), seen[1]));
  static_cast<void>(called.send(text("to one"), seen[0]));
  for (auto* caller : {&one, &two}) {
    const auto got = receive(*caller);
    ASSERT_TRUE(got);
    EXPECT_EQ(got->from, relay->local());
    EXPECT_EQ(std::string(buffer.begin(), buffer.begin() + 6), caller == &one ? "to one" : "to two");
  }
  stop();
  EXPECT_EQ(relay->status().callers, 2U);
  EXPECT_EQ(relay->status().forward.delivered, 2U);
  EXPECT_EQ(relay->status().backward.delivered, 2U);
}

TEST_F(RelayTest, DelaysEachWay) {
  start({.delay_ms = 40.0});
  auto caller = socketAt("127.0.0.2:0");
  for (int i = 0; i < 10; ++i) {
    const Instant sent = Clock::now();
    static_cast<void>(caller.send(text("there"), relay->local()));
    const auto there = receive(called);
    ASSERT_TRUE(there);
    static_cast<void>(called.send(text("back"), there->from));
    ASSERT_TRUE(receive(caller));
    EXPECT_GE(toMilliseconds(Clock::now() - sent), 80.0);
  }
  stop();
  EXPECT_GE(relay->status().forward.delay_ms_min, 40.0);
}

TEST_F(RelayTest, WhatIsSentIsDeliveredLostOrCountedOtherwise) {
  start({.delay_ms = 2, .jitter_ms = 1, .loss_percent = 20, .reorder_percent = 10, .duplicate_percent = 10});
  auto caller = socketAt("127.0.0.2:0");
  constexpr int kCount = 2000;
  std::vector<int> arrived;
  const auto collect = [&] {
    while (receive(called, Duration::zero())) {
      arrived.push_back(std::stoi(std::string(buffer.begin(), buffer.begin() + 6)));
    }
  };
  for (int i = 0; i < kCount; ++i) {
    static_cast<void>(caller.send(text(fmt::format("{:06}", i)), relay->local()));
    if (i % 20 != 19) continue;  // no socket's buffer fills, however late the relay or this test is
    ASSERT_TRUE(comesTrue("the relay to take what was sent", [&] {
      collect();
      return relay->status().forward.received > static_cast<std::uint64_t>(i);
    }));
  }
  EXPECT_TRUE(comesTrue("every datagram to be decided on and to arrive", [&] {
    collect();
    const DirectionStatistics now = relay->status().forward;
    return now.received == now.delivered - now.duplicated + now.lost + now.queue_full &&
           arrived.size() == now.delivered;
  }));
  stop();
  const DirectionStatistics s = relay->status().forward;
  EXPECT_EQ(s.received, static_cast<std::uint64_t>(kCount));
  EXPECT_EQ(s.received, s.delivered - s.duplicated + s.lost + s.queue_full);
  EXPECT_EQ(arrived.size(), s.delivered);
  EXPECT_NEAR(static_cast<double>(s.lost), 400.0, 80.0);  // 4 σ: 72
  EXPECT_GT(s.reordered, 100U);
  EXPECT_FALSE(std::ranges::is_sorted(arrived));
}

TEST_F(RelayTest, AnswersFromOthersAreNotPassedOn) {
  start({});
  auto caller = socketAt("127.0.0.2:0");
  static_cast<void>(caller.send(text("hello"), relay->local()));
  const auto got = receive(called);
  ASSERT_TRUE(got);
  auto other = socketAt("127.0.0.4:0");
  static_cast<void>(other.send(text("forged"), got->from));
  ASSERT_TRUE(comesTrue("the forged answer to be counted", [&] { return relay->status().wrong_peer == 1U; }));
  static_cast<void>(called.send(text("true"), got->from));
  ASSERT_TRUE(receive(caller));
  EXPECT_EQ(std::string(buffer.begin(), buffer.begin() + 4), "true") << "nothing came before it";
  stop();
  EXPECT_EQ(relay->status().wrong_peer, 1U);
}

TEST_F(RelayTest, TheSeventeenthCallerIsRefused) {
  start({});
  std::vector<protocol::UdpSocket> callers;
  for (std::size_t i = 0; i <= NetworkRelay::kMaximumCallers; ++i) {
    callers.push_back(socketAt("127.0.0.2:0"));
    static_cast<void>(callers.back().send(text("hello"), relay->local()));
  }
  for (std::size_t i = 0; i < NetworkRelay::kMaximumCallers; ++i) EXPECT_TRUE(receive(called));
  ASSERT_TRUE(comesTrue("the last caller to be refused", [&] { return relay->status().callers_refused == 1U; }));
  EXPECT_FALSE(receive(called, Duration::zero()));
  stop();
  EXPECT_EQ(relay->status().callers_refused, 1U);
}

TEST_F(RelayTest, ACallerForWhomThereIsNoSocketIsCountedWithTheReason) {
  if (kSanitizerNeedsAFile) GTEST_SKIP() << "the sanitizer needs a file itself";
  start({});
  auto caller = socketAt("127.0.0.2:0");
  EXPECT_TRUE(relay->status().no_socket.empty());
  {
    const NoFreeFile none;
    static_cast<void>(caller.send(text("hello"), relay->local()));
    ASSERT_TRUE(comesTrue("the caller to be refused", [&] { return relay->status().callers_refused > 0; }));
  }
  EXPECT_THAT(relay->status().no_socket.text(), ::testing::HasSubstr("Too many open files"));
  EXPECT_EQ(relay->status().callers, 0U);
  static_cast<void>(caller.send(text("hello"), relay->local()));
  EXPECT_TRUE(receive(called)) << "there is a socket again";
  stop();
}

TEST_F(RelayTest, WrongOptionsAreRefusedWithTheirValue) {
  const auto message = [&](const NetworkRelayOptions& options) {
    const auto made = NetworkRelay::open(options);
    return made ? std::string("opened") : made.error().text();
  };
  const auto free = protocol::parseEndpoint("127.0.0.1:0").value();
  EXPECT_THAT(message({.listen = free, .forward = free}), ::testing::HasSubstr("no port"));
  EXPECT_THAT(message({.listen = called.local(), .forward = called.local()}), ::testing::HasSubstr("another program"));
  const auto left = socketAt("127.0.0.1:0").local();  // a port that was free just now
  EXPECT_THAT(message({.listen = left, .forward = left}), ::testing::HasSubstr("stands on both sides"));
  NetworkRelayOptions wild{.listen = free, .forward = called.local()};
  wild.path.backward.loss_percent = 200;
  EXPECT_THAT(message(wild), ::testing::HasSubstr("loss 200 %"));
}

}  // namespace
}  // namespace fyd::sim
