// One end of a session of FYD Link that hears another, played by hand: what it makes of times and numbers that do not
// follow each other.
#include <gtest/gtest.h>

#include "core/protocol/link/link_connection.h"
#include "tests/unit/protocol/link_pair.h"

namespace fyd::protocol {
namespace {

constexpr LinkTime kBegin_us = 50'000'000;

class LinkConnectionByHand : public testing::Test {
 protected:
  /// A heartbeat of the other end, not given yet. @param round_trip_us that it makes believe, when it arrives now
  Packet heartbeat(LinkTime round_trip_us) {
    Packet out(kMaximumLinkDatagram);
    const std::size_t size = encodeLink(LinkHeartbeat{.echo_us = now_us - round_trip_us},
                                        now_us + theirs_us - round_trip_us / 2, Sealer::messagePart(out));
    out.resize(others.seal(out, size));
    return out;
  }
  LinkReceived give(const Packet& datagram) { return connection.receive(datagram, now_us, parameters); }

  SecretBytes<32> key = testKey().handshakeKey();
  Sealer others{key, 77};
  LinkParameters parameters{.freshness_ms = 5'000.0};
  LinkTime now_us = kBegin_us;
  LinkTime theirs_us = 5'000'000;  // by which the other end's clock is ahead
  LinkConnection connection{key, key, 77, 10.0, now_us};
};

TEST_F(LinkConnectionByHand, TheOffsetOfTheClocksIsThatOfTheShortestRoundTripUntilOneContradictsIt) {
  ASSERT_TRUE(give(heartbeat(2'000)).ok());
  EXPECT_EQ(connection.clock().offset_us(), 5'000'000);
  now_us += 10'000;
  theirs_us += 3'000;  // by half of the longer round trip it cannot be told from a slower way
  ASSERT_TRUE(give(heartbeat(9'000)).clock_sampled);
  EXPECT_EQ(connection.clock().offset_us(), 5'000'000) << "a longer one that agrees";
  EXPECT_EQ(connection.clock().newestRoundTrip_us(), 9'000);
  now_us += 10'000;
  theirs_us += 60'000'000;
  ASSERT_TRUE(give(heartbeat(9'000)).clock_sampled);
  EXPECT_EQ(connection.clock().offset_us(), 65'003'000) << "their clock jumped";
}

TEST_F(LinkConnectionByHand, AClockThatJumpsIsNoJitter) {
  for (int i = 0; i < 200; ++i) {
    now_us += 10'000;
    if (i == 100) theirs_us += 2'000'000;
    ASSERT_TRUE(give(heartbeat(2'000)).ok()) << i;
    EXPECT_EQ(connection.jitter_ms(), 0.0) << i;
  }
  theirs_us += 200'000;  // of less than a second it may as well be the way that is uneven
  now_us += 10'000;
  ASSERT_TRUE(give(heartbeat(2'000)).ok());
  EXPECT_GT(connection.jitter_ms(), 10.0);
}

TEST_F(LinkConnectionByHand, ASecondInWhichOnlyALateDatagramCameLostNothing) {
  const Packet late = heartbeat(2'000);
  for (int i = 0; i < 10; ++i) static_cast<void>(heartbeat(2'000));  // lost on the way
  now_us += 1'000'000;
  ASSERT_TRUE(give(heartbeat(2'000)).ok());
  EXPECT_GT(connection.loss_percent(), 90.0) << "one of twelve came";
  now_us += 1'000'000;
  ASSERT_TRUE(give(late).ok());
  EXPECT_EQ(connection.loss_percent(), 0.0) << "none that was sent meanwhile stayed away";
}

}  // namespace
}  // namespace fyd::protocol
