// The arm's target from touch messages; the test's own formulas give the finger's motion.
#include "core/device/robot/touch_reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include "core/device/robot/motion_limiter.h"
#include "tests/not_a_number.h"

namespace fyd::device {
namespace {

using protocol::RobotPhase;

constexpr double kLag_s = 0.033;

TouchReferenceSettings settingsOf(const char* name) {
  TouchReferenceSettings settings;
  settings.predictor = followingNamed(name).value();
  settings.mapping.scale_z = 1.0;
  return settings;
}

Vec3 circling(double t_s) {
  const double w = 2.0 * std::numbers::pi * 0.8;
  return {20.0 * std::sin(w * t_s), 12.0 * std::cos(w * t_s), -3.0 + std::sin(0.5 * w * t_s)};
}

/// A touchpad that takes 30 pictures and sends 100 touches a second over a way of 50 ms, and a robot end, in the
/// test's own time.
struct Wire {
  explicit Wire(const TouchReferenceSettings& settings) : reference(settings, kLag_s) { reference.reset({}); }

  struct Sent {
    double due_s;
    protocol::RobotReception reception;
  };
  std::function<Vec3(double)> finger = circling;
  std::function<bool(double)> touching = [](double) { return true; };
  std::function<int(double)> copies = [](double) { return 1; };  // of the touch sent then; 0: lost
  double delay_s = 0.050;
  double drift = 0.0;  // of the other end's clock: its dates
  double phase_running_until_s = 1e9;
  TouchReference reference;
  std::deque<Sent> under_way;
  protocol::RobotCounters counters;
  double t_s = 0.0;
  MovingTarget target;

  MovingTarget step() {
    const auto tick = static_cast<int>(std::lround(t_s * 1e3));
    if (tick % 10 == 0) {
      const double picture_s = std::floor(t_s * 30.0 + 1e-9) / 30.0;
      const Vec3 seen = finger(picture_s);
      protocol::RobotReception reception;
      reception.touch =
          pipeline::TouchMessage{.position_mm = {seen.x, seen.y, finger(t_s).z}, .in_contact = touching(t_s)};
      reception.touch_sent = instantAt(100.0 + t_s * (1.0 + drift));
      reception.touch_seen = instantAt(100.0 + picture_s * (1.0 + drift));
      for (int i = copies(t_s); i > 0; --i) under_way.push_back({t_s + delay_s, reception});
    }
    while (!under_way.empty() && under_way.front().due_s <= t_s + 1e-9) {
      reference.take(under_way.front().reception, counters, target.position_mm, now());
      under_way.pop_front();
    }
    target = reference.at(now(), t_s < phase_running_until_s ? RobotPhase::running : RobotPhase::lost);
    t_s += 0.001;
    return target;
  }
  void runTo(double end_s) {
    while (t_s < end_s - 1e-9) step();
  }
  [[nodiscard]] Instant now() const { return instantAt(100.0 + t_s); }
};

/// RMS along the cloth of the target against the finger where it is when the arm gets there.
double rmsAhead(Wire& wire, double seconds) {
  double squares = 0.0;
  const int ticks = static_cast<int>(seconds * 1e3);
  for (int i = 0; i < ticks; ++i) {
    const double then_s = wire.t_s + kLag_s;
    const Vec3 target = wire.step().position_mm;
    const Vec3 truth = wire.finger(then_s);
    squares += (target.x - truth.x) * (target.x - truth.x) + (target.y - truth.y) * (target.y - truth.y);
  }
  return std::sqrt(squares / ticks);
}

TEST(TouchReference, LeadsToWhereTheFingerWillBeWhenTheArmGetsThere) {
  Wire late(settingsOf("order0"));
  Wire led(settingsOf("default"));
  late.runTo(3.0);
  led.runTo(3.0);
  const double held = rmsAhead(late, 2.0);
  const double predicted = rmsAhead(led, 2.0);
  EXPECT_GT(held, 5.0);  // 120 ms of 80 mm/s
  EXPECT_LT(predicted, 0.2 * held);
  const ReferenceFigures figures = led.reference.figures();
  EXPECT_GT(figures.horizon_ms, 80.0);
  EXPECT_LT(figures.horizon_ms, 140.0);
  EXPECT_GT(figures.error_mm, 0.3 * predicted);
  EXPECT_LT(figures.error_mm, 3.0 * predicted);
}

TEST(TouchReference, TheTargetIsContinuousUnderLossDuplicatesAndSilence) {
  for (const std::string_view name : teleop::kPredictorNames) {
    std::mt19937 random(7);
    Wire wire(settingsOf(std::string(name).c_str()));
    wire.copies = [&](double t_s) {
      if (t_s > 3.0 && t_s < 3.637) return 0;
      return t_s < 3.0 ? static_cast<int>(random() % 2) : 3;  // half lost, then all three times
    };
    Vec3 before = wire.step().position_mm;
    while (wire.t_s < 6.0) {
      const MovingTarget target = wire.step();
      ASSERT_TRUE(target.position_mm.finite() && target.velocity_mm_s.finite()) << name;
      const Vec3 moved = target.position_mm - before;
      ASSERT_LT(moved.norm(), 1.5) << name << " at " << wire.t_s;
      ASSERT_NEAR(1e3 * moved.norm(), target.velocity_mm_s.norm(), 250.0) << name << " at " << wire.t_s;
      before = target.position_mm;
    }
  }
}

TEST(TouchReference, APredictionEndsWithTheTouchesItRestsOn) {
  for (const char* name : {"order1", "kalman", "default"}) {
    Wire wire(settingsOf(std::string(name).c_str()));
    wire.copies = [](double t_s) { return t_s < 2.0 ? 1 : 0; };
    wire.runTo(2.04);  // the last touch, sent at 1.99, arrives at 2.04
    wire.runTo(2.04 + 0.150 + 0.2);
    const Vec3 rest = wire.step().position_mm;
    EXPECT_LT((rest - circling(1.967)).norm(), 35.0) << name;  // 350 ms at 100 mm/s
    for (int i = 0; i < 400; ++i) ASSERT_LT((wire.step().position_mm - rest).norm(), 0.02) << name;
    EXPECT_LT(wire.target.velocity_mm_s.norm(), 0.1) << name;
  }
}

TEST(TouchReference, ItEndsAtOnceWithTheLinkAndGoesOnWithoutAJump) {
  Wire wire(settingsOf("default"));
  wire.phase_running_until_s = 2.0;
  wire.copies = [](double t_s) { return t_s < 1.95 || t_s > 2.5 ? 1 : 0; };
  wire.runTo(2.0);
  const Vec3 there = wire.target.position_mm;
  const Vec3 velocity = wire.target.velocity_mm_s;
  wire.runTo(2.15);
  // In the time of the smoothing, 10 ms: as far as the speed goes in it, and no way back.
  EXPECT_NEAR((wire.target.position_mm - there).norm(), 0.010 * velocity.norm(), 0.3);
  EXPECT_LT(wire.target.velocity_mm_s.norm(), 1.0);
}

TEST(TouchReference, ALiftedFingerStopsItWithoutTurningBack) {
  Wire wire(settingsOf("default"));
  wire.touching = [](double t_s) { return t_s < 2.0; };
  wire.runTo(2.0 + wire.delay_s - 0.002);
  const Vec3 direction = wire.target.velocity_mm_s;
  ASSERT_GT(std::hypot(direction.x, direction.y), 30.0);
  Vec3 before = wire.target.position_mm;
  const Vec3 at_lift = before;
  while (wire.t_s < 3.0) {
    const Vec3 next = wire.step().position_mm;
    const Vec3 moved = next - before;
    if (wire.t_s > 2.054) {
      ASSERT_GE(moved.x * direction.x + moved.y * direction.y, -0.02) << wire.t_s;
    }
    before = next;
  }
  EXPECT_LT(std::hypot(before.x - at_lift.x, before.y - at_lift.y), 4.0);
  EXPECT_LT(std::hypot(wire.target.velocity_mm_s.x, wire.target.velocity_mm_s.y), 0.1);
}

// Presses of a hand, then lifted: the tool must leave the thing, not press on it for seconds.
TEST(TouchReference, ALiftedFingersDepthIsThatOfTheTouch) {
  for (const std::string_view name : teleop::kPredictorNames) {
    SCOPED_TRACE(name);
    Wire wire(settingsOf(std::string(name).c_str()));
    const auto pressed = [](double t_s) { return -14.0 * std::pow(std::sin(2.0 * std::numbers::pi * 1.1 * t_s), 2); };
    constexpr double kLifted_s = 5.0 / 1.1;  // where the sine has come back to 0
    wire.finger = [&](double t_s) { return Vec3{5.0, 5.0, t_s < kLifted_s ? pressed(t_s) : 0.0}; };
    wire.touching = [&](double t_s) { return t_s < kLifted_s; };
    wire.runTo(kLifted_s + 0.2);  // 50 ms on its way, and the smoothing
    double furthest_mm = 0.0;
    while (wire.t_s < kLifted_s + 4.0) furthest_mm = std::max(furthest_mm, std::abs(wire.step().position_mm.z));
    EXPECT_LT(furthest_mm, 0.01);
  }
}

TEST(TouchReference, AnOldPictureIsNotPredictedFromForEver) {
  Wire wire(settingsOf("order1"));
  wire.finger = [](double t_s) { return Vec3{std::min(t_s, 2.0) < 2.0 ? 10.0 * t_s : 20.0, 1.0, -2.0}; };
  wire.runTo(1.5);
  // The touches go on, but their picture is that of 1.5 s.
  const protocol::RobotReception last = wire.under_way.back().reception;
  Vec3 place;
  for (int i = 0; i < 2000; ++i) {
    wire.t_s += 0.001;
    if (i % 10 == 0) {
      protocol::RobotReception reception = last;
      reception.touch_sent = wire.now();
      wire.reference.take(reception, wire.counters, wire.target.position_mm, wire.now());
    }
    place = wire.reference.at(wire.now(), RobotPhase::running).position_mm;
  }
  EXPECT_NEAR(place.x, 10.0 * (1.4667 + 0.250), 0.1);  // 250 ms beyond the picture of 1.4667 s
}

TEST(TouchReference, AClockThatDriftsOrLeapsIsFollowed) {
  Wire drifting(settingsOf("default"));
  drifting.drift = 100e-6;
  drifting.runTo(5.0);
  Wire steady(settingsOf("default"));
  steady.runTo(5.0);
  EXPECT_NEAR(rmsAhead(drifting, 2.0), rmsAhead(steady, 2.0), 0.2);
  steady.delay_s = 0.0;  // the way becomes shorter: what is sent later arrives first
  EXPECT_LT(rmsAhead(steady, 2.0), 2.0);
}

TEST(TouchReference, WhatIsNoPlaceLeadsNowhere) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  Wire wire(settingsOf("default"));
  wire.finger = [](double) { return Vec3{5, 5, -1}; };
  wire.runTo(2.0);
  for (const Vec3 bad : {Vec3{kNaN, 0, 0}, Vec3{0, kInf, -1}, Vec3{1, 1, kNaN}, Vec3{1e308, 1e308, -1e308}}) {
    protocol::RobotReception reception;
    reception.touch = pipeline::TouchMessage{.position_mm = bad, .in_contact = true};
    reception.touch_sent = reception.touch_seen = wire.now();
    wire.reference.take(reception, wire.counters, wire.target.position_mm, wire.now());
    EXPECT_TRUE(wire.step().position_mm.finite());
  }
  wire.runTo(4.0);
  EXPECT_NEAR((wire.target.position_mm - Vec3{5, 5, -1}).norm(), 0.0, 0.05);
}

TEST(TouchReference, AfterAnInterruptionTheArmWaitsForAFinger) {
  Wire wire(settingsOf("default"));
  wire.touching = [](double t_s) { return t_s > 2.0; };
  wire.finger = [](double) { return Vec3{9, -7, -2}; };
  wire.reference.resume({1, 2, -30});
  wire.runTo(2.0);
  EXPECT_EQ(wire.target.position_mm, (Vec3{1, 2, -30}));
  wire.runTo(4.0);
  EXPECT_NEAR((wire.target.position_mm - Vec3{9, -7, -2}).norm(), 0.0, 0.05);
  // A gap in the stream of touches counts as one.
  wire.touching = [](double) { return false; };
  wire.runTo(4.2);
  const Vec3 place = wire.target.position_mm;
  ++wire.counters.lost;
  wire.under_way.clear();
  wire.finger = [](double) { return Vec3{0, 0, -60}; };
  wire.runTo(6.0);
  EXPECT_NEAR((wire.target.position_mm - place).norm(), 0.0, 0.05);
}

TEST(TouchReference, TheThesisWayKeepsAShareAtEachTouch) {
  TouchReferenceSettings settings = settingsOf("thesis");
  EXPECT_FALSE(settings.predictor);
  Wire wire(settings);
  wire.finger = [](double) { return Vec3{10, 5, -2}; };
  wire.delay_s = 0.0;
  EXPECT_NEAR(wire.step().position_mm.x, 2.0, 1e-12);  // 0.8 · 0 + 0.2 · 10
  wire.runTo(0.011);
  EXPECT_NEAR(wire.target.position_mm.x, 3.6, 1e-12);
  EXPECT_EQ(wire.target.velocity_mm_s, Vec3{});
}

TEST(TouchReference, WrongSettingsAreRefusedWithTheirValue) {
  const auto message = [](auto change) {
    TouchReferenceSettings settings;
    change(settings);
    const auto good = checkReference(settings);
    return good ? std::string("fine") : good.error().text();
  };
  EXPECT_EQ(message([](auto&) {}), "fine");
  EXPECT_EQ(message([](auto& s) { s.smooth_ms = -1.0; }), "smoothing of -1 ms: expected 0 to 1000");
  EXPECT_THAT(message([&](auto& s) { s.patience_ms = kNaN; }), ::testing::HasSubstr("patience of nan ms"));
  EXPECT_THAT(message([](auto& s) { s.furthest_ms = 2000.0; }), ::testing::HasSubstr("2000 ms at most"));
  EXPECT_THAT(message([](auto& s) { s.lead_ms = 501.0; }), ::testing::HasSubstr("lead of 501 ms: expected 0 to 500"));
  EXPECT_THAT(followingNamed("oracle").error().text(), ::testing::HasSubstr("expected one of thesis, order0"));
}

}  // namespace
}  // namespace fyd::device
