// The station on FYD Link with the simulated robot, over real sockets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "core/device/robot/robot_runner.h"
#include "core/protocol/link/link_key_file.h"
#include "core/sim/robot/robot_arm.h"
#include "core/station/station.h"
#include "tests/wait.h"

namespace fyd::station {
namespace {

class LinkStation : public ::testing::Test {
 protected:
  LinkStation() {
    std::string folder = ::testing::TempDir() + "fyd_link_XXXXXX";
    EXPECT_NE(::mkdtemp(folder.data()), nullptr);
    key_file_ = folder + "/key";
    EXPECT_TRUE(protocol::writeKeyFile(key_, key_file_));
  }
  [[nodiscard]] StationOptions options() const { return {.robot = "link:127.0.0.1:0", .key_file = key_file_}; }
  std::unique_ptr<device::RobotRunner> robot(const Station& station, const protocol::LinkKey& key) {
    device::RobotRunnerOptions out;
    out.touchpad = *protocol::parseEndpoint(station.status().link.local);
    out.bind = *protocol::parseEndpoint("127.0.0.2:0");
    out.key = key;
    return std::move(*device::RobotRunner::open(out, std::make_unique<sim::RobotArm>(sim::SimParameters{})));
  }
  protocol::LinkKey key_ = protocol::LinkKey::generate();
  std::string key_file_;
};

TEST_F(LinkStation, RunsWithARobotThatHasTheKeyAndHearsItsGoodbye) {
  auto station = std::move(*Station::open(options()));
  station->start();
  ASSERT_TRUE(station->setParameter("texture.input_delay_ms", 2.0));
  auto arm = robot(*station, key_);
  std::jthread thread([&](const std::stop_token& stop) { arm->run(stop); });
  EXPECT_TRUE(
      comesTrue("the link to run", [&] { return station->status().link.phase == pipeline::LinkPhase::running; }));
  EXPECT_TRUE(comesTrue("20 touches", [&] { return arm->status().counters.touches > 20; }));
  EXPECT_TRUE(comesTrue("20 states", [&] { return station->status().link.states_received > 20; }));
  const LinkStatus link = station->status().link;
  EXPECT_TRUE(link.secured);
  EXPECT_THAT(link.protocol.text(), ::testing::HasSubstr("FYD Link"));
  EXPECT_EQ(link.peer, protocol::toString(arm->local()));
  EXPECT_GE(link.figures.round_trip_ms, 0.0);
  // The texture waits for the link's batches of 10 ms: its delay is raised, and the operator is told.
  EXPECT_TRUE(comesTrue("the notice of a raised texture.input_delay_ms", [&] {
    for (const Notice& notice : station->takeNotices()) {
      if (notice.message.text().starts_with("texture.input_delay_ms is now") && notice.event.value > 2.0) return true;
    }
    return false;
  }));
  EXPECT_EQ(station->currentProfile().step.texture.input_delay_ms, 2.0);  // the operator's: the network's is not kept
  thread.request_stop();
  thread.join();
  EXPECT_TRUE(
      comesTrue("the robot's goodbye", [&] { return station->status().link.phase == pipeline::LinkPhase::closed; }));
}

TEST_F(LinkStation, RobotWithAnotherKeyIsNotAnswered) {
  auto station = std::move(*Station::open(options()));
  station->start();
  auto arm = robot(*station, protocol::LinkKey::generate());
  std::jthread thread([&](const std::stop_token& stop) { arm->run(stop); });
  EXPECT_TRUE(comesTrue("refused calls", [&] { return station->status().link.refused > 2; }));
  EXPECT_EQ(station->status().link.phase, pipeline::LinkPhase::waiting);
  EXPECT_TRUE(station->status().link.peer.empty());
  ASSERT_FALSE(station->status().link.figures.refusals.empty());
  EXPECT_EQ(station->status().link.figures.refusals[0].reason, "wrong key or damaged");
  thread.request_stop();
  thread.join();
  EXPECT_EQ(arm->status().connections, 0U);
  EXPECT_EQ(arm->status().problem, "no touchpad with this key answered");
}

TEST_F(LinkStation, StationThatStopsTellsTheRobot) {
  auto station = std::move(*Station::open(options()));
  station->start();
  auto arm = robot(*station, key_);
  std::jthread thread([&](const std::stop_token& stop) { arm->run(stop); });
  EXPECT_TRUE(comesTrue("5 touches", [&] { return arm->status().counters.touches > 5; }));
  station->shutDown();
  EXPECT_TRUE(
      comesTrue("the station's goodbye", [&] { return arm->status().phase == protocol::RobotPhase::handshake; }));
  thread.request_stop();
}

TEST_F(LinkStation, WrongOptionsAreNamed) {
  const auto message = [](const StationOptions& wrong) {
    const auto station = Station::open(wrong);
    return station ? std::string("accepted") : station.error().text();
  };
  EXPECT_THAT(message({.robot = "link:127.0.0.1:0"}), ::testing::HasSubstr("needs a key file"));
  EXPECT_THAT(message({.robot = "classic:127.0.0.1:0", .key_file = key_file_}), ::testing::HasSubstr("no key file"));
  EXPECT_THAT(message({.robot = "link:127.0.0.1", .key_file = key_file_}), ::testing::HasSubstr("no port"));
  EXPECT_THAT(message({.robot = "link:127.0.0.1:0", .key_file = key_file_ + "x"}),
              ::testing::HasSubstr("No such file"));
}

}  // namespace
}  // namespace fyd::station
