// Every fault of the simulated touchpad on every backend, unplugged cables, and the test buttons, through a whole
// station. Waits end as soon as their condition holds.
#include "tests/integration/station/device_rig.h"

namespace fyd::station {
namespace {

using pipeline::SafetyState;
using sim::TouchpadFault;
using testing::HasSubstr;

constexpr const char* kMotors = "Motors answer";
constexpr const char* kDistance = "Distance sensors measure";
constexpr const char* kForce = "Load cell measures";
constexpr const char* kCamera = "Camera sees";

struct Cell {
  TouchpadFault fault;
  const char* missing;  ///< line of the readiness list that must go; nullptr: nothing that is needed goes
  const char* words;    ///< that the part's problem must contain meanwhile; nullptr: none need be told
  double seconds = 1.2;
};

const std::vector<Cell> kTouchpadCells = {
    {TouchpadFault::late_reply, kMotors, "answer"},
    {TouchpadFault::silence, kMotors, "answer"},
    {TouchpadFault::stuck_sensor, nullptr, "IR sensor 1 is stuck", 2.5},
    {TouchpadFault::brown_out, kMotors, "answer"},
    {TouchpadFault::encoder_jump, kMotors, "encoder 1 jumped"},
    {TouchpadFault::camera_freeze, nullptr, nullptr},
    {TouchpadFault::garbage, kMotors, "answer"},
    {TouchpadFault::frozen_values, kDistance, "the distance sensors repeat the codes", 2.0},
    {TouchpadFault::bridge_end, kForce, nullptr},
    {TouchpadFault::hot_reading, kDistance, "motor temperatures 3276.7"},
    {TouchpadFault::disobedience, kMotors, "does not obey"},
};
const std::vector<Cell> kCameraCells = {
    {TouchpadFault::late_reply, kCamera, nullptr},
    {TouchpadFault::silence, kCamera, "gives no picture any more", 2.0},
    {TouchpadFault::stuck_sensor, nullptr, nullptr},
    {TouchpadFault::brown_out, kCamera, "gives no picture any more"},
    {TouchpadFault::encoder_jump, nullptr, nullptr},
    {TouchpadFault::camera_freeze, kCamera, "the picture is frozen"},
    {TouchpadFault::garbage, kCamera, "gives no picture any more"},
    {TouchpadFault::camera_flat, kCamera, nullptr},
    {TouchpadFault::camera_damage, kCamera, "sends damaged pictures", 3.0},
    {TouchpadFault::camera_cut, kCamera, "sends damaged pictures", 3.0},
};

class EveryBackend : public testing::TestWithParam<Backend> {};
INSTANTIATE_TEST_SUITE_P(Backends, EveryBackend,
                         testing::Values(Backend::modbus_tcp, Backend::modbus_rtu, Backend::qbmove, Backend::mjpeg),
                         [](const auto& backend) { return kBackendNames[static_cast<std::size_t>(backend.param)]; });

/// Begins the fault and waits for what it does. A jump is told from a fast motor only by a device that answers in time:
/// one that a standstill of the machine hides is begun again.
testing::AssertionResult begins(DeviceRig& rig, const Cell& cell, std::string_view what,
                                const std::function<bool()>& holds) {
  const bool by_its_time = cell.fault == TouchpadFault::encoder_jump;
  const Duration patience = by_its_time ? fromSeconds(cell.seconds + 3.0) : Duration(kPatience);
  testing::AssertionResult came = testing::AssertionFailure();
  for (int attempt = 0; !came && attempt < (by_its_time ? 10 : 1); ++attempt) {
    if (attempt > 0) {
      if (auto armed = rig.armed(); !armed) return armed;
    }
    rig.inject(cell.fault, cell.seconds);
    came = rig.wait(what, holds, patience);
  }
  return came;
}

/// The fault holds the session, and is named.
void expectHeld(DeviceRig& rig, const Cell& cell) {
  bool missing = false;
  bool named = cell.words == nullptr;
  EXPECT_TRUE(begins(rig, cell, "the fault to hold the session and be named",
                     [&] {
                       missing = missing || !rig.lineOk(cell.missing);
                       named = named || rig.told(cell.words);
                       return missing && named && rig.state != SafetyState::active;
                     }))
      << "missing " << missing << ", named " << named;
}

/// The fault is named, if it is to be, and the session stays Active to its end. What a standstill of the machine holds,
/// or hides, is tried again.
void expectHarmless(DeviceRig& rig, const Cell& cell) {
  bool named = false;
  bool active = false;
  const Instant patient_until = Clock::now() + kPatience;
  for (int attempt = 0; Clock::now() < patient_until && !(named && active); ++attempt) {
    if (attempt > 0) {
      ASSERT_TRUE(rig.armed());
    }
    const std::uint64_t before = rig.samples;
    rig.active_samples = 0;
    named = cell.words == nullptr;
    rig.inject(cell.fault, cell.seconds);
    const Instant end = Clock::now() + fromSeconds(cell.seconds);
    ASSERT_TRUE(rig.wait("the end of the fault", [&] {
      named = named || rig.told(cell.words);
      return Clock::now() > end;
    }));
    ASSERT_TRUE(rig.pass(100));
    active = rig.active_samples == static_cast<int>(rig.samples - before);
  }
  EXPECT_TRUE(named) << rig.part().problem.text();
  EXPECT_TRUE(active) << "held after " << rig.active_samples << " steps";
}

TEST_P(EveryBackend, EveryFaultHoldsIsNamedAndNothingReArmsAfterIt) {
  DeviceRig rig(GetParam());
  ASSERT_TRUE(rig.well());
  for (Cell cell : GetParam() == Backend::mjpeg ? kCameraCells : kTouchpadCells) {
    // A motor board of its own obeys whatever the touchpad's motors do.
    if (GetParam() == Backend::qbmove && cell.fault == TouchpadFault::disobedience) cell.missing = nullptr;
    const std::string name(sim::kTouchpadFaultNames[static_cast<std::size_t>(cell.fault)]);
    SCOPED_TRACE(name);
    ASSERT_TRUE(rig.armed());
    if (cell.missing == nullptr) {  // the step does without it
      expectHarmless(rig, cell);
      EXPECT_TRUE(rig.well());
      continue;
    }
    expectHeld(rig, cell);
    const Instant end = Clock::now() + fromSeconds(cell.seconds);
    ASSERT_TRUE(rig.wait("the end of the fault", [&] { return Clock::now() > end; }));
    rig.active_samples = 0;
    EXPECT_TRUE(rig.wait("the sensors' return", [&] { return rig.lineOk(kDistance) && rig.lineOk(kCamera); }));
    EXPECT_TRUE(rig.pass(100));
    EXPECT_EQ(rig.active_samples, 0) << "its return must not arm";
    ASSERT_TRUE(rig.stopped());
    EXPECT_TRUE(rig.well());
  }
  EXPECT_EQ(rig.impossible_angles, 0);
}

TEST_P(EveryBackend, ACableThatComesOutIsShownAndItsReturnDoesNotArm) {
  DeviceRig rig(GetParam());
  // In steps of the loop, which a machine that stands still does not make. One whose drivers stand still beside the
  // loop shows it late: once in three times it must be in time.
  constexpr std::uint64_t kInTime = 500;
  std::uint64_t shown_steps = std::numeric_limits<std::uint64_t>::max();
  for (int pull = 0; pull < 3 && shown_steps >= kInTime; ++pull) {
    ASSERT_TRUE(rig.armed());
    const std::uint64_t out = rig.samples;
    rig.unplug();
    ASSERT_TRUE(rig.wait("the part to be shown as gone", [&] { return !rig.part().ok; }));
    shown_steps = std::min(shown_steps, rig.samples - out);
    EXPECT_TRUE(rig.wait("the end of Active", [&] { return rig.state != SafetyState::active; }));
    EXPECT_NE(rig.part().problem.text(), "");
    rig.startPeer();
    rig.active_samples = 0;
    ASSERT_TRUE(rig.wait("the sensors' return", [&] { return rig.lineOk(kDistance) && rig.lineOk(kCamera); }));
    ASSERT_TRUE(rig.pass(100));
    EXPECT_EQ(rig.active_samples, 0);
    ASSERT_TRUE(rig.stopped());
    EXPECT_TRUE(rig.well());
    EXPECT_TRUE(rig.armed()) << "by the operator's act";
  }
  RecordProperty("shown_steps", static_cast<int>(shown_steps));
  EXPECT_LT(shown_steps, kInTime);
}

class EveryMotorBoard : public testing::TestWithParam<Backend> {};
INSTANTIATE_TEST_SUITE_P(Backends, EveryMotorBoard,
                         testing::Values(Backend::modbus_tcp, Backend::modbus_rtu, Backend::qbmove),
                         [](const auto& backend) { return kBackendNames[static_cast<std::size_t>(backend.param)]; });

TEST_P(EveryMotorBoard, ATouchpadThatRestartsIsArmedAgainFromHeldAndMovesNothingBefore) {
  DeviceRig rig(GetParam());
  ASSERT_TRUE(rig.armed());
  rig.unplug();
  ASSERT_TRUE(rig.wait("Held", [&] { return rig.state == SafetyState::held; }));
  rig.startPeer();
  // A driver that stood still while the touchpad was gone finds it back with its motors off, and says that instead.
  ASSERT_TRUE(rig.wait("everything that is needed, by itself", [&] {
    return rig.linesOk() && (rig.part().ok || rig.isToBeArmed("was lost") || rig.isToBeArmed("are in the state"));
  }));
  ASSERT_TRUE(rig.pass(300));
  EXPECT_EQ(rig.state, SafetyState::held) << "its return must not arm";
  EXPECT_FALSE(rig.process->electronics().figures().motors_on);
  // What the bar says: hold Re-arm. Again where the machine stood still in that very moment.
  const auto works = [&] { return rig.state == SafetyState::active && rig.process->electronics().figures().motors_on; };
  for (int attempt = 0; attempt < 20 && !works(); ++attempt) {
    ASSERT_TRUE(rig.station->command({.action = pipeline::OperatorAction::arm}));
    (void)rig.wait("Active, with motors that are on", works, std::chrono::seconds(2));
  }
  EXPECT_TRUE(works()) << rig.part().problem.text();
}

TEST_P(EveryMotorBoard, WhyItsMotorsWentOffIsShownUntilTheOperatorActs) {
  DeviceRig rig(GetParam());
  std::vector<Cell> cells = {{TouchpadFault::encoder_jump, kMotors, "encoder 1 jumped"}};
  if (GetParam() != Backend::qbmove) cells.push_back({TouchpadFault::disobedience, kMotors, "does not obey"});
  for (const Cell& cell : cells) {
    SCOPED_TRACE(cell.words);
    // Where a standstill of the machine lost the touchpad before the fault came, that is the reason: again.
    bool said = false;
    for (int attempt = 0; attempt < 10 && !said; ++attempt) {
      ASSERT_TRUE(rig.armed());
      expectHeld(rig, cell);
      const Instant two_seconds = Clock::now() + std::chrono::seconds(2);
      ASSERT_TRUE(rig.wait("its readings, two seconds later",
                           [&] { return Clock::now() > two_seconds && rig.lineOk(kMotors) && rig.linesOk(); }));
      ASSERT_TRUE(rig.pass(300));
      EXPECT_EQ(rig.state, SafetyState::held);
      ASSERT_TRUE(rig.wait("a reason to arm again", [&] {  // while nothing is heard that is said instead
        said = rig.isToBeArmed(cell.words);
        return said || rig.isToBeArmed("was lost");
      }));
    }
    EXPECT_TRUE(said) << rig.part().problem.text();
    EXPECT_TRUE(rig.wait("sensors that count, as for a calibration", [&] {
      const device::DeviceReport sensors = rig.station->devices().front();
      return sensors.ok || sensors.measures;
    }));
    // No stop is needed. Again where the machine stood still in that very moment, and the touchpad was lost once more.
    const auto works = [&] { return rig.state == SafetyState::active && rig.part().ok; };
    for (int attempt = 0; attempt < 20 && !works(); ++attempt) {
      ASSERT_TRUE(rig.station->command({.action = pipeline::OperatorAction::arm}));
      (void)rig.wait("Active, and the end of the complaint", works, std::chrono::seconds(2));
    }
    ASSERT_TRUE(works()) << rig.part().problem.text();
  }
}

TEST(StationDevices, ReportsCarryWhatADevicesPageShows) {
  DeviceRig rig(Backend::qbmove);
  std::vector<device::DeviceReport> devices;
  ASSERT_TRUE(rig.wait("three devices that are well and tell their values", [&] {
    devices = rig.station->devices();
    return rig.allOk() && devices.size() == 3U && std::ranges::all_of(devices, [](const auto& device) {
             return device.ok && device.age_ms < 2000.0 && !device.values.empty();
           });
  }));
  EXPECT_EQ(devices[0].kind.text(), "Modbus TCP");
  EXPECT_EQ(devices[1].kind.text(), "qbmove");
  EXPECT_EQ(devices[2].kind.text(), "folder");
  const auto has = [](const device::DeviceReport& report, std::string_view name) {
    return std::ranges::any_of(report.values, [&](const auto& value) { return value.name.text() == name; });
  };
  EXPECT_TRUE(has(devices[0], "IR sensor 3"));
  EXPECT_TRUE(has(devices[0], "status word"));
  EXPECT_TRUE(has(devices[1], "encoder 2"));
  EXPECT_TRUE(rig.wait("the motor board's currents", [&] { return has(rig.station->devices()[1], "current 1"); }));
  EXPECT_EQ(devices[2].controls.size(), 3U);
  EXPECT_THAT(devices[2].controls[0].words.text(), HasSubstr("a folder has none"));
}

class TestButtons : public testing::TestWithParam<Backend> {};
INSTANTIATE_TEST_SUITE_P(Backends, TestButtons, testing::Values(Backend::modbus_tcp, Backend::qbmove),
                         [](const auto& backend) { return kBackendNames[static_cast<std::size_t>(backend.param)]; });

TEST_P(TestButtons, AHeldButtonMovesTheMotorALittleAndItsReleaseEndsIt) {
  DeviceRig rig(GetParam());
  ASSERT_TRUE(rig.well());
  const auto motor = [&] { return rig.process->world().truth().motor_deg[0]; };
  // A machine that stands still for 20 ms ends a test, rightly: the operator presses again.
  double furthest = 0.0;
  double start = 0.0;
  for (const Instant end = Clock::now() + kPatience; furthest < 1.0 && Clock::now() < end;) {
    start = motor();
    if (!rig.station->startDeviceTest(device::DeviceTest::motor_1)) {
      ASSERT_TRUE(rig.pass(100));
      continue;
    }
    ASSERT_TRUE(rig.wait("a degree, or the end of the test", [&] {
      rig.station->keepDeviceTest();
      furthest = std::max(furthest, motor() - start);
      return furthest > 1.0 || !rig.station->deviceTestStatus().running;
    }));
  }
  EXPECT_GT(furthest, 1.0) << rig.station->deviceTestStatus().words.text();
  EXPECT_LT(furthest, 3.0);
  rig.station->stopDeviceTest();
  EXPECT_TRUE(rig.wait("the motors to be off", [&] { return !rig.process->electronics().figures().motors_on; }));
  EXPECT_FALSE(rig.station->deviceTestStatus().running);
  ASSERT_TRUE(rig.armed());
  EXPECT_THAT(rig.station->startDeviceTest(device::DeviceTest::vibration).error().text(),
              HasSubstr("stop the session"));
}

}  // namespace
}  // namespace fyd::station
