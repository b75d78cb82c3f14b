// UDP sockets on the loopback interface.
#include <optional>

#include <net/if.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string_view>
#include <vector>

#include "app/bench/parts/allocation_count.h"
#include "core/protocol/classic/classic_robot_end.h"
#include "core/protocol/classic/classic_touchpad_end.h"
#include "core/protocol/udp_socket.h"
#include "tests/wait.h"

namespace fyd::protocol {
namespace {

using std::chrono::milliseconds;

UdpSocket opened(std::string_view address) { return UdpSocket::open(parseEndpoint(address).value()).value(); }

TEST(Endpoint, ReadsAndWritesBothFamilies) {
  for (const std::string_view address :
       {"127.0.0.1:3490", "0.0.0.0:0", "255.1.2.3:65535", "[::1]:3490", "[fe80::1]:1"}) {
    EXPECT_EQ(toString(parseEndpoint(address).value()), address);
  }
  EXPECT_EQ(toString(parseEndpoint("localhost:3490").value()), "127.0.0.1:3490");
  EXPECT_EQ(parseEndpoint("[fe80::1%lo]:1").value().scope, ::if_nametoindex("lo"));
  EXPECT_EQ(toString(parseEndpoint("[fe80::1%lo]:1").value()), "[fe80::1%lo]:1");
  EXPECT_NE(parseEndpoint("127.0.0.1:1").value(), parseEndpoint("127.0.0.1:2").value());
  EXPECT_NE(parseEndpoint("127.0.0.1:1").value(), parseEndpoint("127.0.0.2:1").value());
}

TEST(Endpoint, SaysWhichPartIsWrong) {
  const auto message = [](std::string_view address) { return parseEndpoint(address).error().text(); };
  EXPECT_THAT(message("127.0.0.1"), ::testing::HasSubstr("no port"));
  EXPECT_THAT(message("127.0.0.1:"), ::testing::HasSubstr("port \"\""));
  EXPECT_THAT(message("127.0.0.1:65536"), ::testing::HasSubstr("port \"65536\""));
  EXPECT_THAT(message("127.0.0.1:-1"), ::testing::HasSubstr("0 to 65535"));
  EXPECT_THAT(message("127.0.0.1:34x"), ::testing::HasSubstr("port \"34x\""));
  EXPECT_THAT(message("256.0.0.1:1"), ::testing::HasSubstr("\"256.0.0.1\" is not an IPv4 address"));
  EXPECT_THAT(message("robot.example:1"), ::testing::HasSubstr("not looked up"));
  EXPECT_THAT(message("::1:3490"), ::testing::HasSubstr("brackets"));
  EXPECT_THAT(message("[127.0.0.1]:1"), ::testing::HasSubstr("not an IPv6 address"));
  EXPECT_THAT(message("[fe80::1%nosuch]:1"), ::testing::HasSubstr("no network interface \"nosuch\""));
  EXPECT_THAT(message("[fe80::1%]:1"), ::testing::HasSubstr("no network interface \"\""));
  EXPECT_THAT(message("[::1%lo]:1"), ::testing::HasSubstr("only a link-local address"));
  EXPECT_THAT(message(""), ::testing::HasSubstr("HOST:PORT"));
  EXPECT_THAT(message(":1"), ::testing::HasSubstr("not an IPv4 address"));
}

TEST(UdpSocket, PortThatIsTakenIsNamedWithTheReason) {
  const UdpSocket first = opened("127.0.0.1:0");
  const auto second = UdpSocket::open(first.local());
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().text(), ::testing::HasSubstr(toString(first.local())));
  EXPECT_THAT(second.error().text(), ::testing::HasSubstr("another program holds the port"));
  Endpoint other_address = first.local();
  other_address.address[3] = 2;  // 127.0.0.2, the same port: both ends on one host
  EXPECT_TRUE(UdpSocket::open(other_address));
}

TEST(UdpSocket, AddressThatIsNotThisMachinesIsRefused) {
  const auto socket = UdpSocket::open(parseEndpoint("192.0.2.1:0").value());
  ASSERT_FALSE(socket);
  EXPECT_THAT(socket.error().text(), ::testing::HasSubstr("UDP 192.0.2.1:0"));
}

TEST(UdpSocket, CarriesDatagramsOfEverySizeIncludingNone) {
  UdpSocket a = opened("127.0.0.1:0");
  UdpSocket b = opened("127.0.0.2:0");
  std::vector<std::uint8_t> buffer(kMaximumDatagram);
  for (const std::size_t size : {0U, 1U, 62U, 1'400U, 57'599U, 65'507U}) {
    const std::vector<std::uint8_t> payload(size, 0x5a);
    ASSERT_EQ(a.send(payload, b.local()), SendOutcome::sent) << size;
    const auto received = b.receive(buffer, kPatience);
    ASSERT_TRUE(received) << size;
    EXPECT_EQ(received->size, size);
    EXPECT_EQ(received->from, a.local());
  }
  const std::vector<std::uint8_t> too_long(65'508);
  EXPECT_EQ(a.send(too_long, b.local()), SendOutcome::refused);
}

TEST(UdpSocket, WaitsNoLongerThanAsked) {
  UdpSocket socket = opened("127.0.0.1:0");
  std::vector<std::uint8_t> buffer(100);
  EXPECT_FALSE(socket.receive(buffer, Duration::zero()));
  const Instant before = Clock::now();
  EXPECT_FALSE(socket.receive(buffer, milliseconds(20)));
  EXPECT_GE(Clock::now() - before, milliseconds(20));
}

TEST(UdpSocket, OfSeveralAnyThatHasADatagramEndsTheWaiting) {
  UdpSocket first = opened("127.0.0.1:0");
  UdpSocket second = opened("127.0.0.2:0");
  const std::array<const UdpSocket*, 2> both{&first, &second};
  EXPECT_FALSE(waitForAny(both, Duration::zero()));
  EXPECT_FALSE(waitForAny({}, milliseconds(1))) << "none at all";
  ASSERT_EQ(first.send(std::array<std::uint8_t, 1>{7}, second.local()), SendOutcome::sent);
  EXPECT_TRUE(waitForAny(both, kPatience));
  EXPECT_FALSE(waitForAny(std::span(both).first(1), Duration::zero())) << "it is the other's";
  EXPECT_TRUE(waitForAny(both, Duration::zero())) << "it is still there";
}

TEST(UdpSocket, PortNobodyListensOnIsNoFailureOfTheReceiver) {
  UdpSocket socket = opened("127.0.0.1:0");
  const Endpoint nobody = opened("127.0.0.1:0").local();  // closed again at once
  std::vector<std::uint8_t> buffer(100);
  const std::array<std::uint8_t, 3> payload{1, 2, 3};
  for (int i = 0; i < 10; ++i) {
    static_cast<void>(socket.send(payload, nobody));
    EXPECT_FALSE(socket.receive(buffer, milliseconds(1)));
  }
  UdpSocket peer = opened("127.0.0.1:0");
  ASSERT_EQ(peer.send(payload, socket.local()), SendOutcome::sent);
  EXPECT_TRUE(socket.receive(buffer, kPatience));
}

TEST(UdpSocket, WorksOverIpv6) {
  auto a = UdpSocket::open(parseEndpoint("[::1]:0").value());
  if (!a) GTEST_SKIP() << "no IPv6 here: " << a.error().text();
  UdpSocket b = opened("[::1]:0");
  std::vector<std::uint8_t> buffer(100);
  ASSERT_EQ(a->send(std::array<std::uint8_t, 1>{7}, b.local()), SendOutcome::sent);
  const auto received = b.receive(buffer, kPatience);
  ASSERT_TRUE(received);
  EXPECT_EQ(received->from, a->local());
}

void answerAll(UdpSocket& socket, ClassicTouchpadEnd& end, const TouchpadAnswer& answer,
               std::span<std::uint8_t> buffer) {
  while (const auto got = socket.receive(buffer, Duration::zero())) {
    for (const Datagram& reply : end.handle({buffer.data(), got->size}, got->from, Clock::now(), answer).replies) {
      EXPECT_EQ(socket.send(reply.bytes, reply.to), SendOutcome::sent);
    }
  }
}

TEST(ClassicOverUdp, SessionStaysInStepAmongThousandsOfGarbageDatagrams) {
  UdpSocket touchpad = opened("127.0.0.1:0");
  UdpSocket robot = opened("127.0.0.2:0");
  UdpSocket enemy = opened("127.0.0.3:0");
  LinkParameters parameters;
  parameters.takeover_silence_s = 600;  // a busy machine must not lend the enemy the robot's place
  ClassicTouchpadEnd end(parameters);
  ClassicRobotEnd self({.reply_timeout = kPatience}, touchpad.local());
  TouchpadAnswer answer;
  answer.touch = {.position_mm = {3, 4, -5}, .in_contact = true, .force_N = 1.0};
  answer.board_text = "test board";
  std::vector<std::uint8_t> buffer(kMaximumDatagram);

  std::mt19937_64 random(5);
  std::vector<std::uint8_t> garbage(1'000);
  const auto state = encodeState({.command = pipeline::RobotCommand::disconnect});
  const auto ack = encodeAck();
  const auto attack = [&](const Endpoint& victim) {
    for (auto& byte : garbage) byte = static_cast<std::uint8_t>(random());
    static_cast<void>(enemy.send(Bytes(garbage).first(random() % garbage.size()), victim));
    static_cast<void>(enemy.send(Bytes(state).first(random() % (state.size() + 1)), victim));
    static_cast<void>(enemy.send(Bytes(ack).first(random() % (ack.size() + 1)), victim));
  };

  constexpr std::uint64_t kCycles = 3'000;
  for (std::uint64_t i = 0; i <= kCycles; ++i) {
    if (i > 0) attack(touchpad.local());
    for (const Datagram& datagram : self.tick(Clock::now(), {.robot = {.stiffness_N_per_mm = 0.6}})) {
      ASSERT_EQ(robot.send(datagram.bytes, datagram.to), SendOutcome::sent);
    }
    if (i > 0) attack(touchpad.local());
    attack(robot.local());
    const auto arrived = [&] {  // the system may deliver late
      return !self.replyDue() && self.counters().wrong_peer == 3 * (i + 1) &&
             end.counters().wrong_peer + end.counters().second_robot == 6 * i;
    };
    const Instant give_up = Clock::now() + kPatience;
    do {
      answerAll(touchpad, end, answer, buffer);
      while (const auto got = robot.receive(buffer, Duration::zero())) {
        static_cast<void>(self.handle({buffer.data(), got->size}, got->from));
      }
    } while (!arrived() && Clock::now() < give_up);
    ASSERT_TRUE(arrived()) << "cycle " << i;
  }
  EXPECT_EQ(self.counters().states, kCycles);
  EXPECT_EQ(self.counters().touches, kCycles);
  EXPECT_EQ(self.counters().extra_touches + self.counters().missed_replies + self.counters().refused, 0U);
  EXPECT_EQ(self.counters().wrong_peer, 3 * (kCycles + 1));
  EXPECT_EQ(self.boardText(), "test board");
  EXPECT_EQ(end.counters().states, kCycles);
  EXPECT_EQ(end.counters().wrong_peer + end.counters().second_robot, 6 * kCycles);
  EXPECT_EQ(end.peer(), robot.local());
}

TEST(ClassicOverUdp, ExchangeDoesNotAllocate) {
  UdpSocket touchpad = opened("127.0.0.1:0");
  UdpSocket robot = opened("127.0.0.2:0");
  ClassicTouchpadEnd end{LinkParameters{}};
  ClassicRobotEnd self({.reply_timeout = kPatience}, touchpad.local());
  std::vector<std::uint8_t> buffer(kMaximumDatagram);
  std::optional<bench::AllocationCount> counted;
  for (int i = 0; i < 200; ++i) {
    if (i == 10) counted.emplace();
    for (const Datagram& datagram : self.tick(Clock::now(), {})) {
      static_cast<void>(robot.send(datagram.bytes, datagram.to));
    }
    const Instant give_up = Clock::now() + kPatience;
    while (self.replyDue() && Clock::now() < give_up) {
      answerAll(touchpad, end, {}, buffer);
      while (const auto got = robot.receive(buffer, Duration::zero())) {
        static_cast<void>(self.handle({buffer.data(), got->size}, got->from));
      }
    }
  }
  EXPECT_EQ(counted->count(), 0U);
  EXPECT_EQ(self.counters().touches, 199U);
}

}  // namespace
}  // namespace fyd::protocol
