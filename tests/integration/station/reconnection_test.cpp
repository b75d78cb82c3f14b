// Touchpad and robot end in one process, over real sockets and a wire that can be cut: whatever goes away and comes
// back, the arm is not told to move while the touchpad is not Active.
#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/robot/robot_runner.h"
#include "core/protocol/link/link_key_file.h"
#include "core/sim/robot/robot_arm.h"
#include "core/station/station.h"

namespace fyd::station {
namespace {

using pipeline::OperatorAction;
using pipeline::SafetyState;
using std::chrono::milliseconds;

protocol::Endpoint at(const std::string& text) { return protocol::parseEndpoint(text).value(); }

/// Between one robot and the touchpad, until it is cut.
class Wire {
 public:
  explicit Wire(const protocol::Endpoint& touchpad)
      : touchpad_(touchpad), thread_([this](const std::stop_token& stop) { carry(stop); }) {}
  [[nodiscard]] const protocol::Endpoint& local() const { return near_.local(); }
  std::atomic<bool> cut{false};

 private:
  void carry(const std::stop_token& stop) {
    std::vector<std::uint8_t> buffer(protocol::kMaximumDatagram);
    std::optional<protocol::Endpoint> robot;
    const std::array<const protocol::UdpSocket*, 2> both = {&near_, &far_};
    while (!stop.stop_requested()) {
      if (!protocol::waitForAny(both, milliseconds(5))) continue;
      while (const auto got = near_.receive(buffer, Duration::zero())) {
        robot = got->from;
        if (!cut) static_cast<void>(far_.send(std::span(buffer).first(got->size), touchpad_));
      }
      while (const auto got = far_.receive(buffer, Duration::zero())) {
        if (!cut && robot) static_cast<void>(near_.send(std::span(buffer).first(got->size), *robot));
      }
    }
  }
  protocol::Endpoint touchpad_;
  protocol::UdpSocket near_ = protocol::UdpSocket::open(at("127.0.0.4:0")).value();
  protocol::UdpSocket far_ = protocol::UdpSocket::open(at("127.0.0.5:0")).value();
  std::jthread thread_;
};

/// Where an arm is told to be, and how far that ever was from a mark.
struct Told {
  std::mutex mutex;
  Vec3 place_mm;
  Vec3 mark_mm;
  double farthest_mm = 0.0;
  std::uint64_t exchanges = 0;

  Vec3 place() {
    const std::lock_guard lock(mutex);
    return place_mm;
  }
  void mark() {
    const std::lock_guard lock(mutex);
    mark_mm = place_mm;
    farthest_mm = 0.0;
  }
  double farthest() {
    const std::lock_guard lock(mutex);
    return farthest_mm;
  }
};

class WatchedArm final : public device::Robot {
 public:
  explicit WatchedArm(std::shared_ptr<Told> told) : arm_(sim::SimParameters{}), told_(std::move(told)) {}
  [[nodiscard]] Message description() const override { return verbatim("watched"); }
  [[nodiscard]] bool inVirtualTime() const override { return true; }
  [[nodiscard]] Result<device::RobotReadings> exchange(const Vec3& target_mm, Instant now) override {
    {
      const std::lock_guard lock(told_->mutex);
      told_->place_mm = target_mm;
      told_->farthest_mm = std::max(told_->farthest_mm, (target_mm - told_->mark_mm).norm());
      ++told_->exchanges;
    }
    return arm_.exchange(target_mm, now);
  }

 private:
  sim::RobotArm arm_;
  std::shared_ptr<Told> told_;
};

class Reconnection : public ::testing::TestWithParam<const char*> {
 protected:
  Reconnection() {
    std::string folder = ::testing::TempDir() + "fyd_back_XXXXXX";
    EXPECT_NE(::mkdtemp(folder.data()), nullptr);
    key_file_ = folder + "/key";
    EXPECT_TRUE(protocol::writeKeyFile(key_, key_file_));
  }
  [[nodiscard]] bool secured() const { return std::string(GetParam()) == "link"; }

  void openStation(const std::string& address) {
    StationOptions options{.robot = fmt::format("{}:{}", GetParam(), address)};
    if (secured()) options.key_file = key_file_;
    station_ = Station::open(options).value();
    station_->start();
    state_ = SafetyState::disconnected;
  }
  void startRobot() {
    device::RobotRunnerOptions options;
    options.touchpad = wire_->local();
    options.bind = at("127.0.0.2:0");
    options.link.ack_retry = milliseconds(100);
    if (secured()) options.key = key_;
    told_ = std::make_shared<Told>();
    robot_ = device::RobotRunner::open(options, std::make_unique<WatchedArm>(told_)).value();
    robot_thread_ = std::jthread([this](const std::stop_token& stop) { robot_->run(stop); });
  }
  void stopRobot() {
    robot_thread_.request_stop();
    robot_thread_.join();
  }
  bool until(const std::function<bool()>& done) {
    const Instant deadline = Clock::now() + std::chrono::seconds(40);
    while (Clock::now() < deadline) {
      std::array<pipeline::TelemetrySample, 1000> batch;
      const std::size_t taken = station_->takeTelemetry(batch);
      if (taken > 0) state_ = batch[taken - 1].state;
      if (done()) return true;
      std::this_thread::sleep_for(milliseconds(5));
    }
    return false;
  }
  bool untilState(SafetyState state) {
    return until([&] { return state_ == state; });
  }
  /// Armed, again whenever a busy machine held it, with the finger where it leads the arm down and aside.
  bool leadAway() {
    int cycles = 0;
    return until([&] {
      if (state_ != SafetyState::active && cycles++ % 40 == 0) {
        (void)station_->command({.action = OperatorAction::arm});
      }
      station_->moveSimulatedFinger(state_ == SafetyState::active ? 10.0 : 4.0, 5.0, 6.0);
      return state_ == SafetyState::active && told_->place().z < -8.0;
    });
  }
  /// `more` touches have come, so that one that moves the arm would have.
  bool hears(std::uint64_t more) {
    const std::uint64_t before = robot_->status().counters.touches;
    return until([&] { return robot_->status().counters.touches >= before + more; });
  }
  bool connected(std::uint64_t times) {
    return until([&] { return robot_->status().connections >= times; });
  }
  /// The arm has come to rest where it was led to.
  bool atRest() {
    Vec3 last = told_->place();
    int still = 0;
    return until([&] {
      still = told_->place() == last ? still + 1 : 0;
      last = told_->place();
      return still > 20;
    });
  }
  bool handshaking() {
    return until([&] { return robot_->status().phase == protocol::RobotPhase::handshake; });
  }

  protocol::LinkKey key_ = protocol::LinkKey::generate();
  std::string key_file_;
  std::unique_ptr<Station> station_;
  std::optional<Wire> wire_;
  std::shared_ptr<Told> told_;
  std::unique_ptr<device::RobotRunner> robot_;
  std::jthread robot_thread_;
  SafetyState state_ = SafetyState::disconnected;
};

TEST_P(Reconnection, NothingMovesTheArmWhileTheTouchpadIsNotActive) {
  openStation("127.0.0.1:0");
  const std::string address = station_->status().link.local;
  wire_.emplace(at(address));
  startRobot();
  ASSERT_TRUE(connected(1)) << "the robot connects";
  ASSERT_TRUE(untilState(SafetyState::ready));
  ASSERT_TRUE(leadAway()) << "the finger leads the arm";

  // Lost for so short a time that the session stands, while the finger moves on until the touchpad is held.
  wire_->cut = true;
  ASSERT_TRUE(until([&] {
    station_->moveSimulatedFinger(-10.0, 0.0, 2.0);
    return state_ == SafetyState::held;
  }));
  ASSERT_TRUE(atRest());
  told_->mark();
  wire_->cut = false;
  ASSERT_TRUE(hears(50));
  EXPECT_EQ(state_, SafetyState::held);
  EXPECT_LT(told_->farthest(), 1e-6) << "moved by what it had missed";
  ASSERT_TRUE(leadAway());
  const std::uint64_t sessions = robot_->status().connections;

  // Lost for more than a second, held, and back: the same robot, the same touchpad.
  wire_->cut = true;
  ASSERT_TRUE(untilState(SafetyState::held));
  ASSERT_TRUE(handshaking()) << "the robot gives up";
  ASSERT_TRUE(atRest());
  told_->mark();
  wire_->cut = false;
  ASSERT_TRUE(connected(sessions + 1)) << "the robot is back";
  ASSERT_TRUE(hears(50));
  EXPECT_EQ(state_, SafetyState::held);
  EXPECT_LT(told_->farthest(), 1e-6) << "moved while held";

  // The same again while stopped.
  station_->requestStop();
  ASSERT_TRUE(untilState(SafetyState::stopped));
  wire_->cut = true;
  ASSERT_TRUE(handshaking());
  wire_->cut = false;
  ASSERT_TRUE(connected(sessions + 2));
  ASSERT_TRUE(hears(50));
  EXPECT_EQ(state_, SafetyState::stopped);
  EXPECT_LT(told_->farthest(), 1e-6) << "moved while stopped";

  // Another touchpad process: it starts at no touch at all, and the finger may lie on the cloth.
  station_.reset();
  openStation(address);
  station_->moveSimulatedFinger(-10.0, -5.0, 3.0);
  ASSERT_TRUE(connected(sessions + 3));
  ASSERT_TRUE(untilState(SafetyState::ready));
  ASSERT_TRUE(hears(50));
  EXPECT_LT(told_->farthest(), 1e-6) << "moved while ready";

  // Armed, the finger leads it again.
  ASSERT_TRUE(leadAway());
  EXPECT_TRUE(until([&] { return told_->farthest() > 1.0; })) << "follows again";

  // Another robot, which stands at its own start, while the touchpad is held with the finger pressed.
  wire_->cut = true;
  ASSERT_TRUE(untilState(SafetyState::held));
  stopRobot();
  startRobot();
  told_->mark();
  const Vec3 start = told_->place();
  wire_->cut = false;
  ASSERT_TRUE(connected(1));
  ASSERT_TRUE(hears(50));
  EXPECT_EQ(state_, SafetyState::held);
  EXPECT_LT(told_->farthest(), 1e-6) << "another robot moved while held";
  EXPECT_LT(start.norm(), 1e-6);
  stopRobot();
}

INSTANTIATE_TEST_SUITE_P(Protocols, Reconnection, ::testing::Values("classic", "link"),
                         [](const auto& protocol) { return std::string(protocol.param); });

}  // namespace
}  // namespace fyd::station
