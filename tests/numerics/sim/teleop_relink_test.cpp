// Two arms with time-domain passivity, one direction of whose line is dead for a while: only one of them links anew.
#include <cmath>
#include <deque>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/sim/teleop/desktop_arm.h"
#include "core/sim/teleop/teleop_end.h"

namespace fyd::sim {
namespace {

constexpr double kStep_s = 0.001;
constexpr int kParts = 10;  // of a step, for the mechanics
constexpr teleop::CouplingSettings kSpring{.stiffness_N_per_m = 200.0, .damping_N_s_per_m = 3.0, .most_force_N = 20.0};

TeleopEndSettings endOf(bool at_hand) {
  TeleopEndSettings out;
  out.at_hand = at_hand;
  out.coupling = teleop::CouplingChoice::tdpa;
  out.coupling_settings = kSpring;
  return out;
}

struct OneWay {
  std::deque<std::pair<int, std::vector<std::uint8_t>>> underway;
  bool dead = false;
  void carry(TeleopEnd& from, TeleopEnd& to, int now, int delay) {
    while (!underway.empty() && underway.front().first <= now) {
      to.receive(underway.front().second, kStep_s * now);
      underway.pop_front();
    }
    const auto bytes = from.datagram(kStep_s * now);
    if (!bytes.empty() && !dead) underway.emplace_back(now + delay, std::vector(bytes.begin(), bytes.end()));
  }
};

/// A hand that swings its arm by 40 mm, and an arm that follows, along x. At the far one somebody pulls, too.
class SwungPair {
 public:
  explicit SwungPair(int delay_ms) : delay_(delay_ms) {
    hand_.start(1);
    far_.start(2);
  }

  /// @return root mean square of the far arm's distance from the hand's, mm
  double run(double seconds) {
    double squares = 0.0;
    const int steps = static_cast<int>(std::lround(seconds / kStep_s));
    for (int i = 0; i < steps; ++i) {
      step();
      const double apart_mm = far_arm_.position_mm().x - hand_arm_.position_mm().x;
      squares += apart_mm * apart_mm;
    }
    return std::sqrt(squares / steps);
  }

  OneWay there, back;
  double pull_N = 0.0;            ///< amplitude, at the far arm
  bool swings = true;             ///< the hand; else it is held
  std::vector<double> hand_in_J;  ///< put in there, by each step
  double far_out_J = 0.0;         ///< given by the spring there, since it linked
  int far_links = 0;              ///< how many times
  int far_linked_at = 0;          ///< the last one
  int hand_links = 0;

 private:
  static bool linked(const TeleopEnd& end) { return end.phase() == TeleopEnd::Phase::linked; }

  void step() {
    const double t = kStep_s * now_;
    const bool far_was = linked(far_), hand_was = linked(hand_);
    there.carry(hand_, far_, now_, delay_);
    back.carry(far_, hand_, now_, delay_);
    hand_links += linked(hand_) && !hand_was ? 1 : 0;
    if (linked(far_) && !far_was) {
      ++far_links;
      far_linked_at = now_;
      far_out_J = 0.0;
    }
    const double hand_at = 1e-3 * hand_arm_.measured_mm().x, far_at = 1e-3 * far_arm_.measured_mm().x;
    const double given_J = felt_N_ * (hand_at - hand_at_m_);  // to the hand by its spring
    hand_in_J.push_back((hand_in_J.empty() ? 0.0 : hand_in_J.back()) + std::max(0.0, -given_J));
    if (far_was && linked(far_)) far_out_J += std::max(0.0, spring_N_ * (far_at - far_at_m_));
    hand_at_m_ = hand_at;
    far_at_m_ = far_at;
    const double far_v = far_arm_.velocity_mm_per_s().x;
    const Vec3 felt = hand_.step({hand_arm_.measured_mm(), hand_arm_.velocity_mm_per_s(), {}, {}}, t);
    const Vec3 drive = far_.step({far_arm_.measured_mm(), far_arm_.velocity_mm_per_s(), {}, {}}, t);
    felt_N_ = felt.x;
    spring_N_ = drive.x + kSpring.damping_N_s_per_m * 1e-3 * far_v;
    const double swing = 2.0 * std::numbers::pi * 0.7 * t;
    for (int part = 0; part < kParts; ++part) {
      const double target_mm = swings ? 40.0 * std::sin(swing) : 0.0;
      const double arm_N =
          hand_arm_.position_mm().x * -1.0 + target_mm - 0.03 * hand_arm_.velocity_mm_per_s().x;  // 1000 N/m
      hand_arm_.step(felt, {arm_N, 0.0, 0.0}, kStep_s / kParts);
      far_arm_.step(drive, {pull_N * std::sin(1.6 * swing), 0.0, 0.0}, kStep_s / kParts);
    }
    ++now_;
  }

  int delay_, now_ = 0;
  TeleopEnd hand_{endOf(true)}, far_{endOf(false)};
  DesktopArm hand_arm_{0.5}, far_arm_;
  double felt_N_ = 0.0, spring_N_ = 0.0, hand_at_m_ = 0.0, far_at_m_ = 0.0;
};

TEST(TeleopRelink, AFarEndThatStaysLinkedFollowsAHandThatLinkedAnew) {
  SwungPair pair(10);
  pair.run(15.0);
  const double before_mm = pair.run(5.0);
  pair.back.dead = true;
  pair.run(0.6);
  pair.back.dead = false;
  pair.run(2.0);  // links, and takes up the distance
  ASSERT_EQ(pair.hand_links, 2);
  ASSERT_EQ(pair.far_links, 1);
  const double after_mm = pair.run(5.0);
  EXPECT_LE(after_mm, 2.0 * before_mm);
  EXPECT_LE(before_mm, 15.0);  // it follows at all
}

TEST(TeleopRelink, AFarEndThatLinkedAnewGivesNothingTwice) {
  constexpr int kDelay_ms = 100, kPeriod_ms = 10;
  SwungPair pair(kDelay_ms);
  pair.pull_N = 3.0;
  pair.run(20.0);
  ASSERT_GT(pair.hand_in_J.back(), 3.0);
  pair.there.dead = true;
  pair.run(0.6);
  pair.there.dead = false;
  pair.swings = false;
  pair.run(0.4);
  ASSERT_EQ(pair.far_links, 2);
  ASSERT_EQ(pair.hand_links, 1);
  for (int i = 0; i < 50; ++i) {
    pair.run(0.1);
    // The first message that the far end counts from was under way.
    const auto first = static_cast<std::size_t>(pair.far_linked_at - kDelay_ms - kPeriod_ms);
    ASSERT_LE(pair.far_out_J, pair.hand_in_J.back() - pair.hand_in_J[first] + 1e-3) << i;
  }
}

}  // namespace
}  // namespace fyd::sim
