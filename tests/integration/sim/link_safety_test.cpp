// FYD Link with the whole step behind it, in virtual time: the effect of a lost link on motors and vibration.
#include <gtest/gtest.h>

#include "core/sim/touchpad/lockstep.h"
#include "tests/unit/protocol/link_pair.h"

namespace fyd::sim {
namespace {

using pipeline::SafetyState;

// A touchpad's step fed by its end of the link, a robot that shakes at the other end of the wire.
class LinkedTouchpad {
 public:
  LinkedTouchpad() : session_(options()) {
    pair.weather = {.delay_ms = 3.0, .jitter_ms = 5.0, .loss = 0.01};
    session_.spoil = [this](pipeline::Inputs& in) {
      in.robot.phase = pair.touchpad.phase();
      in.robot.state.set({.stiffness_N_per_mm = 0.62}, in.now);
      in.robot.accelerations.clear();
      for (const auto& sample : pair.samples) {
        // The pair's clock and the step's began at different times.
        auto shifted = sample;
        shifted.taken = in.now - (pair.now - sample.taken);
        (void)in.robot.accelerations.push(shifted);
      }
      pair.samples.clear();
    };
    pair.keep_samples = true;
  }
  const pipeline::Outputs& step() {
    const double phase = 0.9 * static_cast<double>(steps_++);
    pair.report.acceleration_g = {2.0 * std::sin(phase), 1.5 * std::cos(0.7 * phase), std::sin(1.3 * phase)};
    pair.step();
    return session_.step();
  }
  void arm() { (void)session_.next.commands.push({.action = pipeline::OperatorAction::arm}); }
  template <class Done>
  bool stepUntil(Done&& done, int most) {
    for (int i = 0; i < most; ++i) {
      if (done(step())) return true;
    }
    return false;
  }

  protocol::LinkPair pair;

 private:
  static LockstepOptions options() {
    LockstepOptions out;
    out.draw_pictures = false;
    out.parameters.texture.input_delay_ms = 30.0;  // a batch of 10 ms, 8 ms under way, one lost
    return out;
  }
  Lockstep session_;
  std::uint64_t steps_ = 0;
};

TEST(LinkSafety, LostLinkIsSafeWithinTheLimitAThousandTimesAndNeverReengagesByItself) {
  constexpr int kSafeWithin_ms = 20;  // after the loss is declared
  std::mt19937_64 random(8);
  LinkedTouchpad touchpad;
  ASSERT_TRUE(touchpad.pair.connect());
  const auto isActive = [](const pipeline::Outputs& out) { return out.telemetry.state == SafetyState::active; };
  double most_vibration = 0.0;
  for (int i = 0; i < 1'000; ++i) {
    ASSERT_TRUE(touchpad.stepUntil(
        [&](const pipeline::Outputs& out) {
          if (out.telemetry.state != SafetyState::active) touchpad.arm();
          return isActive(out);
        },
        5'000))
        << i;
    for (std::uint64_t n = 50 + random() % 100; n > 0; --n) {
      const auto& out = touchpad.step();
      ASSERT_TRUE(isActive(out)) << "false stop, " << i;
      most_vibration = std::max(most_vibration, std::abs(out.telemetry.vibration_duty_percent));
    }
    touchpad.pair.cut = true;
    const Instant cut = touchpad.pair.now;
    ASSERT_TRUE(touchpad.stepUntil([&](const pipeline::Outputs& out) { return !isActive(out); }, 200)) << i;
    const double limit_ms = touchpad.pair.touchpad.lostLimit_ms();
    EXPECT_LE(limit_ms, 100.0);
    EXPECT_LE(toMilliseconds(touchpad.pair.now - cut), limit_ms + 8.0 + 2.0);  // and what was under way
    bool quiet = false;
    const Instant declared = touchpad.pair.now;
    std::array<double, 2> frozen{};
    for (std::uint64_t n = 30 + random() % 60; n > 0; --n) {
      const auto& out = touchpad.step();
      EXPECT_EQ(out.telemetry.state, SafetyState::held);
      if (touchpad.pair.now - declared < std::chrono::milliseconds(kSafeWithin_ms)) continue;
      const std::array<double, 2> now{static_cast<double>(out.motors.reference_ticks[0]),
                                      static_cast<double>(out.motors.reference_ticks[1])};
      EXPECT_EQ(out.telemetry.vibration_duty_percent, 0.0);
      if (quiet) {
        EXPECT_EQ(now, frozen);
      }
      frozen = now;
      quiet = true;
    }
    touchpad.pair.cut = false;
    ASSERT_TRUE(touchpad.stepUntil(
        [&](const pipeline::Outputs& out) {
          EXPECT_FALSE(isActive(out));
          return touchpad.pair.touchpad.phase() == pipeline::LinkPhase::running;
        },
        5'000));
    for (int n = 0; n < 50; ++n) EXPECT_EQ(touchpad.step().telemetry.state, SafetyState::held);  // until armed again
  }
  EXPECT_GT(most_vibration, 5.0);  // there was something to stop
}

}  // namespace
}  // namespace fyd::sim
