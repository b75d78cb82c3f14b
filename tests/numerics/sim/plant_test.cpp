// Hard cases of the simulation: determinism, time, commands that are no numbers, size, threads, and the
// figures that show what the cloth plane of the thesis makes of a pushed membrane.
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/sensing/membrane.h"
#include "core/sim/touchpad/ir_sensor.h"
#include "core/sim/touchpad/simulated_camera.h"
#include "core/sim/touchpad/simulated_touchpad.h"
#include "tests/sweep.h"

namespace fyd::sim {
namespace {

using namespace std::chrono_literals;

const Instant kStart = instantAt(1.0);

bool identical(const device::TouchpadReadings& a, const device::TouchpadReadings& b) {
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are what is asked for; there is no padding
  const bool same_bridge = std::memcmp(&a.bridge.value, &b.bridge.value, sizeof a.bridge.value) == 0;
  return std::equal(a.ir.value.begin(), a.ir.value.end(), b.ir.value.begin()) && a.ir.taken == b.ir.taken &&
         a.ir.count == b.ir.count && same_bridge && a.bridge.taken == b.bridge.taken &&
         a.motors.value.encoder_counts == b.motors.value.encoder_counts &&
         a.motors.value.current_mA == b.motors.value.current_mA && a.motors.taken == b.motors.taken;
}

control::MotorCommand commandAt(int ms) {
  const auto ticks = static_cast<std::int16_t>(2000 + 1500 * std::sin(ms * 0.003));
  return {.reference_ticks = {ticks, static_cast<std::int16_t>(-ticks)},
          .vibration_duty_percent = {20.0 * std::sin(ms * 0.7), 20.0 * std::sin(ms * 0.7)},
          .active = true};
}

SimParameters unkind(int seed) {
  SimParameters parameters;
  parameters.seed = seed;
  parameters.cloth_stiffness_scale = 1.3;
  parameters.cloth_hysteresis = 0.1;
  parameters.motor_friction_percent = 8.0;
  parameters.ir_delay_ms = 20.0;
  parameters.bridge_delay_ms = 7.5;
  return parameters;
}

TEST(Determinism, TheSameSeedAndCommandsGiveTheSameBits) {
  auto a = std::make_shared<TouchpadWorld>(unkind(5), FingerPath::demonstration(), kStart);
  auto b = std::make_shared<TouchpadWorld>(unkind(5), FingerPath::demonstration(), kStart);
  auto other = std::make_shared<TouchpadWorld>(unkind(6), FingerPath::demonstration(), kStart);
  SimulatedTouchpad one(a);
  SimulatedTouchpad two(b);
  SimulatedTouchpad three(other);
  SimulatedCamera camera(b);
  bool differs = false;
  for (int ms = 4; ms < 8000; ms += 4) {
    const Instant now = kStart + std::chrono::milliseconds(ms);
    b->advanceTo(now - 1ms);  // as a camera thread does in between: it must not matter
    if (ms % 32 == 0) static_cast<void>(camera.frameAt(now));
    const auto first = one.exchange(commandAt(ms), now).value();
    const auto second = two.exchange(commandAt(ms), now).value();
    ASSERT_TRUE(identical(first, second)) << ms;
    differs = differs || !identical(first, three.exchange(commandAt(ms), now).value());
  }
  EXPECT_TRUE(differs) << "another seed is another run";
}

TEST(Time, StandingStillAndGoingBackDoNothing) {
  TouchpadWorld world({}, FingerPath::demonstration(), kStart);
  world.advanceTo(kStart + 150ms);
  const auto before = world.readings();
  for (const Instant bad : {kStart + 150ms, kStart, kStart - 1h, Instant::min()}) {
    world.advanceTo(bad);
    EXPECT_TRUE(identical(world.readings(), before));
  }
  world.advanceTo(kStart + 151ms);
  EXPECT_EQ(world.readings().motors.taken, kStart + 151ms);
}

TEST(Time, AJumpIsBoundedAndTheWorldGoesOnBehindIt) {
  TouchpadWorld world({}, FingerPath::constant(0, 0, 4), kStart);
  world.command({.reference_ticks = {4200, -4200}, .active = true});
  const std::uint64_t before = world.readings().motors.count;
  world.advanceTo(kStart + 24h);
  EXPECT_EQ(world.readings().motors.count - before, 200U) << "200 steps and not 86 million";
  EXPECT_EQ(world.readings().motors.taken, kStart + 24h);
  EXPECT_LE(world.truth().angle_deg, 20.0 + 0.2 * 180.0);
  EXPECT_EQ(world.readings().ir.taken + 17ms > kStart + 24h, true) << "sensors are on time again";
  const Instant in_a_century = instantAt(3.2e9);
  world.advanceTo(in_a_century);
  EXPECT_LE(in_a_century - world.readings().motors.taken, 1ms);
  EXPECT_NEAR(world.truth().force_N, 4.0 * world.truth().stiffness_N_per_mm, 1e-12);
}

TEST(Commands, ThatAreNoNumbersLeaveTheWorldFinite) {
  auto world = std::make_shared<TouchpadWorld>(unkind(1), FingerPath::demonstration(), kStart);
  SimulatedTouchpad touchpad(world);
  Instant now = kStart;
  for (const double duty : {double(NAN), double(INFINITY), -double(INFINITY), 1e308, -5e-324}) {
    for (const int reference : {-32768, 32767, 0}) {
      const auto ticks = static_cast<std::int16_t>(reference);
      for (int i = 0; i < 300; ++i) {
        const auto readings = touchpad.exchange(
            {.reference_ticks = {ticks, ticks}, .vibration_duty_percent = {duty, duty}, .active = true}, now += 1ms);
        ASSERT_TRUE(readings);
        ASSERT_TRUE(std::isfinite(readings->bridge.value.value_mV_per_V));
        for (const std::uint16_t counts : readings->motors.value.encoder_counts) ASSERT_LE(counts, 4095);
        for (const std::uint16_t code : readings->ir.value) ASSERT_LE(code, 4095);
        ASSERT_TRUE(std::isfinite(world->truth().force_N) && std::isfinite(world->truth().angle_deg));
      }
    }
  }
}

TEST(LongRecording, OfAMillionRowsLoadsAndAnswersAnywhere) {
  const auto file = (std::filesystem::temp_directory_path() / fmt::format("fyd_million_{}.csv", ::getpid())).string();
  {
    std::ofstream out(file);
    out << "t_s,x_mm,y_mm,z_mm\n";
    for (int i = 0; i < 1'000'000; ++i) out << i * 1e-3 << ".5," << i % 300 << ",0," << i % 100 << '\n';
  }
  EXPECT_FALSE(FingerPath::fromCsv(file)) << "two points in a number";
  {
    std::ofstream out(file);
    out << "t_s,x_mm,y_mm,z_mm\n";
    for (int i = 0; i < 1'000'000; ++i) out << i << ',' << i % 300 << ",0," << i % 100 << '\n';
  }
  const auto path = FingerPath::fromCsv(file);
  std::filesystem::remove(file);
  ASSERT_TRUE(path) << path.error().text();
  EXPECT_EQ(path->rows(), 1'000'000U);
  double sum = 0.0;
  for (int i = 0; i < 1'000'000; ++i) sum += path->at(i * 0.9).indentation_mm;  // hopeless unless the look-up is fast
  EXPECT_GT(sum, 0.0);
  EXPECT_NEAR(path->at(600'000.0).x_mm, -45.0, 1e-9);
}

/// What the thesis' plane says at the finger, of distances without noise, beside the truth.
TEST(Membrane, ThePlaneOfTheThesisFallsShortOfThePressByTheseFigures) {
  const sensing::Membrane membrane;
  double worst = 0.0;
  double squares = 0.0;
  int count = 0;
  const auto planeAt = [&](double x, double y) {
    std::array<double, 3> z{};
    for (std::size_t i = 0; i < 3; ++i) z[i] = membrane.shape(kIrPlaces[i].x_mm, kIrPlaces[i].y_mm, x, y);
    return 9 * z[0] / 20 + z[1] / 10 + 9 * z[2] / 20 - x * z[0] / 44 + x * z[2] / 44 - y * z[0] / 60 + y * z[1] / 30 -
           y * z[2] / 60;
  };
  for (const double x : stepsTo(-45.0, 45.0, 5.0)) {
    for (const double y : stepsTo(-30.0, 30.0, 5.0)) {
      const double error = 5.0 * (planeAt(x, y) - 1.0);  // mm, for a press of 5 mm
      worst = std::max(worst, std::abs(error));
      squares += error * error;
      ++count;
    }
  }
  const double rms = std::sqrt(squares / count);
  const std::string figures = fmt::format(
      "press 5 mm: centre {:+.2f} mm, at a sensor (22, -3) {:+.2f} mm, between (11, 12) {:+.2f} mm, corner "
      "(45, 30) {:+.2f} mm; RMS over the area {:.2f} mm, worst {:.2f} mm",
      5.0 * (planeAt(0, 0) - 1.0), 5.0 * (planeAt(22, -3) - 1.0), 5.0 * (planeAt(11, 12) - 1.0),
      5.0 * (planeAt(45, 30) - 1.0), rms, worst);
  std::printf("%s\n", figures.c_str());
  RecordProperty("plane_error", figures);
  EXPECT_NEAR(planeAt(22, -3), 1.0, 1e-9) << "exact under a sensor";
  EXPECT_LT(5.0 * (planeAt(0, 0) - 1.0), -1.0) << "far off between them";
  EXPECT_GT(rms, 1.0);
  EXPECT_LT(worst, 6.0);
}

TEST(Threads, CameraAndDeviceShareOneWorld) {
  const Instant start = Clock::now();
  SimParameters parameters;
  parameters.camera_rate_Hz = 120.0;
  auto world = std::make_shared<TouchpadWorld>(parameters, FingerPath::demonstration(), start);
  std::thread camera_thread([&] {
    SimulatedCamera camera(world);
    for (int i = 0; i < 20; ++i) static_cast<void>(camera.next());
  });
  std::thread mouse([&] {
    for (int i = 0; i < 50; ++i) {
      world->setFingerOverride(FingerState{.x_mm = 0.1 * i, .indentation_mm = 2.0, .lifted = false});
      std::this_thread::sleep_for(2ms);
    }
  });
  SimulatedTouchpad touchpad(world);
  Instant last{};
  for (int i = 0; i < 150; ++i) {
    const auto readings = touchpad.exchange(commandAt(i), Clock::now()).value();
    ASSERT_GE(readings.motors.taken, last);
    last = readings.motors.taken;
    std::this_thread::sleep_for(1ms);
  }
  camera_thread.join();
  mouse.join();
  EXPECT_NEAR(world->truth().finger.x_mm, 4.9, 1e-9);
}

TEST(SimParameters, DescribeThemselvesWithDefaultsInRange) {
  SimParameters parameters;
  for (const Parameter& parameter : bindParameters(parameters)) {
    EXPECT_TRUE(parameter.id.starts_with("sim.")) << parameter.id;
    EXPECT_TRUE(checkParameter(parameter, parameter.value())) << parameter.id;
    EXPECT_FALSE(parameter.info.help.empty()) << parameter.id;
  }
}

}  // namespace
}  // namespace fyd::sim
