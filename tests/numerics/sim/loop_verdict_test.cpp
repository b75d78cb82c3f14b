// What the loop's model says of gains, against what the simulated touchpad does with them. The two share the controller
// and nothing else: the touchpad has its own motors with friction, current and speed limits, encoders, a cloth, and
// sensors with noise through the whole pipeline.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/control/loop_prediction.h"
#include "core/control/static_law.h"
#include "core/sim/trial/stiffness_trial.h"

namespace fyd::sim {
namespace {

using control::ControlMode;
using control::ControlParameters;
using control::LoopVerdict;

constexpr double kDuration_s = 10.0;

/// Whether the rollers still swing in the second half: more than three swings of 1.5° or more.
bool swingsOn(const std::vector<TrialPoint>& course) {
  int swings = 0, direction = 0;
  double lowest = course.back().stretch_deg, highest = lowest;
  for (const TrialPoint& point : course) {
    if (point.time_s < kDuration_s / 2) {
      lowest = highest = point.stretch_deg;
      continue;
    }
    lowest = std::min(lowest, point.stretch_deg);
    highest = std::max(highest, point.stretch_deg);
    const bool up = direction <= 0 && point.stretch_deg > lowest + 1.5;
    const bool down = !up && direction >= 0 && point.stretch_deg < highest - 1.5;
    if (!up && !down) continue;
    direction = up ? 1 : -1;
    (up ? highest : lowest) = point.stretch_deg;
    ++swings;
  }
  return swings > 3;
}

struct Count {
  int cells = 0;
  int swinging = 0;        ///< on the touchpad
  int missed = 0;          ///< the touchpad swings on, the model calls it anything but unstable
  int called_settled = 0;  ///< of these, called "settles"
  int false_alarms = 0;
  std::string wrong;
};

/// One cell of the grid: the same gains on the touchpad and on the model.
void judge(ControlParameters control, double encoder_delay_ms, Count& count) {
  control.measurement_bias = 0.0;
  StiffnessTrial trial;
  trial.sim.cloth = ClothKind::ideal;
  trial.sim.cloth_stiffness_scale = 0.7;
  trial.sim.encoder_delay_ms = encoder_delay_ms;
  trial.parameters.sensing.indentation.mode = sensing::IndentationMode::membrane;
  trial.parameters.control = control;
  trial.duration_s = kDuration_s;
  const control::StaticLaw law(control);
  trial.target_N_per_mm = 0.7 * std::sqrt(law.minimumStiffness_N_per_mm() * law.maximumStiffness_N_per_mm());
  std::vector<TrialPoint> course;
  (void)runTrial(trial, &course);
  const bool swings = swingsOn(course);

  // An encoder's delay is one way; the timing counts it there and back.
  const auto said =
      control::predictLoop(control::assumedCloth(control), control, {.motors_age_s = encoder_delay_ms / 2000.0});
  const bool thesis = control.mode == ControlMode::thesis;
  const double kp = thesis ? control.thesis_kp : control.kp, ki = thesis ? control.thesis_ki : control.ki_per_s;
  EXPECT_TRUE(std::isfinite(said.margins.gain_margin)) << "kp " << kp << " ki " << ki;
  const bool unstable = said.verdict == LoopVerdict::unstable;
  ++count.cells;
  count.swinging += swings ? 1 : 0;
  count.missed += swings && !unstable ? 1 : 0;
  count.called_settled += swings && said.verdict == LoopVerdict::settles ? 1 : 0;
  count.false_alarms += !swings && unstable ? 1 : 0;
  if (swings != unstable) count.wrong += "  " + std::to_string(kp) + " " + std::to_string(ki) + "\n";
}

void record(const Count& count) {
  testing::Test::RecordProperty("cells", count.cells);
  testing::Test::RecordProperty("swinging", count.swinging);
  testing::Test::RecordProperty("missed", count.missed);
  testing::Test::RecordProperty("false_alarms", count.false_alarms);
}

class LoopVerdictOf : public testing::TestWithParam<int> {};

TEST_P(LoopVerdictOf, GainsIsWhatTheTouchpadDoes) {
  Count count;
  for (const double kp : {0.15, 1.0, 3.0, 6.0, 10.0, 15.0, 20.0}) {
    for (const double ki : {0.0, 5.0, 20.0, 50.0, 80.0, 120.0}) {
      ControlParameters control;
      control.kp = kp;
      control.ki_per_s = ki;
      judge(control, GetParam(), count);
    }
  }
  record(count);
  EXPECT_GE(count.swinging, 12) << "the grid reaches beyond what the touchpad bears";
  EXPECT_LE(count.called_settled, 0) << count.wrong;
  EXPECT_LE(count.missed, 2) << count.wrong;
  EXPECT_LE(count.false_alarms, 7) << count.wrong;
}

INSTANTIATE_TEST_SUITE_P(EncodersLateBy_ms, LoopVerdictOf, testing::Values(0, 4, 10));

TEST(LoopVerdictOfThesisGains, IsWhatTheTouchpadDoes) {
  Count count;
  for (const double kp : {0.0, 20.0, 60.0, 100.0, 200.0, 300.0, 400.0}) {
    for (const double ki : {20.0, 60.0, 150.0, 300.0, 600.0, 800.0}) {
      ControlParameters control;
      control.mode = ControlMode::thesis;
      control.thesis_kp = kp;
      control.thesis_ki = ki;
      judge(control, 0.0, count);
    }
  }
  record(count);
  EXPECT_GE(count.swinging, 12) << "the grid reaches beyond what the touchpad bears";
  EXPECT_LE(count.missed, 2) << count.wrong;
  EXPECT_LE(count.false_alarms, 5) << count.wrong;
}

}  // namespace
}  // namespace fyd::sim
