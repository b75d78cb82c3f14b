#include "core/sim/teleop/teleop_run.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/protocol/link/message_budget.h"
#include "core/sim/teleop/desktop_arm.h"
#include "core/teleop/coupling/coupling_choice.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::sim {
namespace {

using teleop::CouplingChoice;
using teleop::PredictorChoice;

teleop::Trace swing(double amplitude_mm, double hertz, double seconds) {
  teleop::Trace out{.axes = 1, .time_s = {}, .position_mm = {}};
  for (int i = 0; i < static_cast<int>(1000.0 * seconds); ++i) {
    const double t = 0.001 * i;
    out.time_s.push_back(t);
    out.position_mm.push_back({amplitude_mm * std::sin(2.0 * std::numbers::pi * hertz * t), 0.0, 0.0});
  }
  return out;
}

TeleopRunSettings over(double delay_ms, PredictorChoice predictor, CouplingChoice coupling = CouplingChoice::model) {
  TeleopRunSettings out{.predictor = predictor, .coupling = coupling};
  out.path.forward.delay_ms = out.path.backward.delay_ms = delay_ms;
  return out;
}

TEST(DesktopArm, HasThePapersFigures) {
  const auto code = protocol::PositionCode::make(DesktopArm::workspace());
  ASSERT_TRUE(code);
  EXPECT_EQ(code->bitsPerAxis(), 13U);  // equation 1: 160 / 0.02 = 8000 points
  EXPECT_NEAR(code->pointsOfLongestAxis(), 8000U, 2U);
  DesktopArm arm;
  arm.step({100.0, 0.0, 0.0}, {}, 0.001);  // 6.4 N on 45 g for 1 ms
  EXPECT_NEAR(arm.velocity_mm_per_s().x, 6.4 / 0.045, 0.1);
  for (int i = 0; i < 1000; ++i) arm.step({6.4, std::nan(""), 0.0}, {}, 0.001);
  EXPECT_EQ(arm.position_mm().x, 80.0);  // a stop
  EXPECT_EQ(arm.velocity_mm_per_s().x, 0.0);
  EXPECT_EQ(arm.measured_mm().y, 0.0);
}

TEST(DeviceMessage, GoesThroughAnIsdnLineEachTenMilliseconds) {
  const auto code = *protocol::PositionCode::make(DesktopArm::workspace());
  protocol::DeviceMessage message{.session = 7,
                                  .date_s = 12.345678,
                                  .position_mm = {12.34, -50.0, 64.98},
                                  .orientation = {1.0, -2.0, 3.0},
                                  .force_N = {1.234, -6.4, 40.0},
                                  .axes = {}};
  message.axes[1] = {.touching = true, .knows_surface = true, .surface_m = 0.0125, .stiffness_N_per_m = 800.0};
  std::array<std::uint8_t, protocol::kMostDeviceMessage> bytes{};
  const std::size_t size = encode(message, code, bytes);
  EXPECT_LE(8 * (size + 28), 640U);  // equation 2: 64 kbit/s · 10 ms
  const auto again = protocol::decodeDeviceMessage(std::span(bytes).first(size), code);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->session, 7);
  EXPECT_NEAR(again->date_s, 12.345678, 1e-6);
  EXPECT_NEAR(again->position_mm.x, 12.34, 0.0101);
  EXPECT_NEAR(again->position_mm.z, 64.98, 0.0101);
  EXPECT_NEAR(again->orientation.beta_rad, -2.0, 1e-4);
  EXPECT_NEAR(again->force_N.x, 1.234, 5e-4);
  EXPECT_NEAR(again->force_N.z, 32.767, 1e-9);  // held at what can be said
  EXPECT_TRUE(again->axes[1].touching && again->axes[1].knows_surface && !again->axes[0].knows_surface);
  EXPECT_NEAR(again->axes[1].surface_m, 0.0125, 1e-8);
  for (std::size_t cut = 0; cut < size; ++cut)
    EXPECT_FALSE(protocol::decodeDeviceMessage(std::span(bytes).first(cut), code)) << cut;
}

TEST(DeviceMessage, WithADeadbandItRepeatsTheTwoBefore) {
  const auto code = *protocol::PositionCode::make(DesktopArm::workspace());
  protocol::DeviceMessage message{.session = 7,
                                  .date_s = 12.5,
                                  .position_mm = {12.34, -50.0, 64.98},
                                  .force_N = {1.234, -6.4, 4.0},
                                  .number = 4'000'000'000U,
                                  .velocity_mm_per_s = {-123.4, 0.05, 9999.0},
                                  .earlier = {},
                                  .axes = {}};
  ASSERT_TRUE(message.earlier.push({12.25, {1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}, {0.7, 0.8, 0.9}}));
  ASSERT_TRUE(message.earlier.push({12.375, {-1.0, -2.0, -3.0}, {-4.0, -5.0, -6.0}, {-0.7, -0.8, -0.9}}));
  for (auto& axis : message.axes) axis = {.knows_surface = true, .surface_m = 0.01, .stiffness_N_per_m = 500.0};
  message.tells_energy = true;
  std::array<std::uint8_t, protocol::kMostDeviceMessage> bytes{};
  const std::size_t size = encode(message, code, bytes);
  ASSERT_GT(size, 0U);  // the longest there is
  const auto again = protocol::decodeDeviceMessage(std::span(bytes).first(size), code);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->number, 4'000'000'000U);
  EXPECT_NEAR(again->velocity_mm_per_s.x, -123.4, 1e-9);
  EXPECT_NEAR(again->velocity_mm_per_s.z, 3276.7, 1e-9);  // held at what can be said
  ASSERT_EQ(again->earlier.size(), 2U);
  EXPECT_NEAR(again->earlier[0].date_s, 12.25, 1e-6);
  EXPECT_NEAR(again->earlier[1].date_s, 12.375, 1e-6);
  EXPECT_NEAR(again->earlier[1].position_mm.y, -2.0, 0.0101);
  EXPECT_NEAR(again->earlier[0].velocity_mm_per_s.z, 6.0, 1e-9);
  EXPECT_NEAR(again->earlier[1].force_N.z, -0.9, 1e-9);
  for (std::size_t cut = 0; cut < size; ++cut) {
    const auto shorter = protocol::decodeDeviceMessage(std::span(bytes).first(cut), code);
    EXPECT_TRUE(!shorter || shorter->earlier.size() < 2) << cut;  // whole samples may be left out, nothing else
  }
}

TEST(TeleopRun, ADeadbandSendsLessAndWhatIsToldStaysWithinItWhereAFifthIsLost) {
  auto settings = over(30.0, PredictorChoice::experts);
  settings.wall_N_per_m = 500.0;
  for (NetworkSettings* way : {&settings.path.forward, &settings.path.backward}) {
    way->jitter_ms = 10.0;
    way->loss_percent = 20.0;
  }
  const auto trace = swing(25.0, 0.6, 8.0);
  const TeleopFigures every = runTeleop(trace, settings, nullptr);
  EXPECT_TRUE(std::isnan(every.told_share));
  double before_per_s = 1e9;
  for (const double percent : {5.0, 10.0, 20.0}) {
    settings.deadband_percent = percent;
    const TeleopFigures out = runTeleop(trace, settings, nullptr);
    EXPECT_LT(out.packets_per_s, before_per_s) << percent;
    before_per_s = out.packets_per_s;
    EXPECT_LT(out.packets_per_s, 0.6 * every.packets_per_s) << percent;
    EXPECT_LT(out.back_packets_per_s, 100.0) << percent;  // of 1 kHz a tenth
    EXPECT_LE(out.deadband_worst, 1.001) << percent;      // a microsecond is the date's step
    EXPECT_LE(out.deadband_force_worst, 1.001) << percent;
    EXPECT_GT(out.deadband_worst, 0.5) << percent;
    EXPECT_GT(out.told_share, 0.95) << percent;
    EXPECT_GT(out.told_force_share, 0.95) << percent;
    EXPECT_LT(out.rms_error_mm, 1.5 * every.rms_error_mm) << percent;
    EXPECT_GE(out.least_energy_J, -1e-3) << percent;
    EXPECT_EQ(out.linked_share, every.linked_share) << percent;  // never lost
  }
}

TEST(TeleopRun, WhatADeadbandTellsStaysWithinItAlsoWhenOneEndWasLostMeanwhile) {
  // The hand's end hears nothing for 0.8 s, so that it is lost, while the far one stays linked and keeps what it knows.
  auto settings = over(30.0, PredictorChoice::experts);
  settings.deadband_percent = 10.0;
  for (int i = 0; i <= 8000; ++i) {
    settings.path.backward.trace.t_s.push_back(0.001 * i);
    settings.path.backward.trace.delay_ms.push_back(i >= 3000 && i < 3800 ? std::nan("") : 30.0);
  }
  const auto trace = swing(25.0, 0.6, 8.0);
  std::vector<TeleopRow> rows;
  const TeleopFigures out = runTeleop(trace, settings, &rows);
  EXPECT_GT(out.linked_share, 0.98) << "the far end, all the time";
  EXPECT_LE(out.deadband_worst, 1.001);  // a microsecond is the date's step
  EXPECT_GT(out.deadband_worst, 0.5);
  EXPECT_LE(out.deadband_force_worst, 1.001);
  int known = 0, known_later = 0;
  for (const TeleopRow& row : rows) {
    if (std::isnan(row.told_x_mm)) continue;
    ++known;
    known_later += row.t_s > 4.0 ? 1 : 0;
    // The band of the paper, and the encoder's half step: the row is the hand, what is told its encoder.
    EXPECT_NEAR(row.told_x_mm, row.hand_mm[0], std::max(0.1, 0.10 * 0.05 * std::abs(row.told_x_mm_per_s)) + 0.0101)
        << row.t_s;
  }
  EXPECT_GT(known, 6000);
  EXPECT_GT(known_later, 3000);
}

TEST(TeleopRun, WhatWasNeverLinkedOrNeverMovedHasNoErrorsInsteadOfNone) {
  auto lossy = over(20.0, PredictorChoice::experts), late = over(5000.0, PredictorChoice::experts);
  lossy.path.forward.loss_percent = lossy.path.backward.loss_percent = 100.0;
  const auto trace = swing(25.0, 0.6, 2.0);
  auto lifted = trace;
  for (auto& each : lifted.position_mm) each[0] = std::nan("");
  const std::vector<std::pair<teleop::Trace, TeleopRunSettings>> cases = {
      {trace, lossy}, {trace, late}, {lifted, over(20.0, PredictorChoice::experts)}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const TeleopFigures out = runTeleop(cases[i].first, cases[i].second, nullptr);
    EXPECT_FALSE(out.linked_share > 0.0) << i;
    for (const double each :
         {out.rms_error_mm, out.max_error_mm, out.believed_rms_mm, out.believed_max_mm, out.added_delay_ms,
          out.jerk_ratio, out.vibration_ratio, out.largest_step_mm, out.orientation_rms_deg, out.told_share}) {
      EXPECT_TRUE(std::isnan(each)) << i;
    }
  }
  EXPECT_TRUE(std::isnan(runTeleop(lifted, over(20.0, PredictorChoice::experts), nullptr).drag_N));
}

TEST(TeleopRun, HeldMessagesComeAsLateAsTheyAreAndPredictedOnesDoNot) {
  const auto trace = swing(30.0, 1.0, 6.0);
  const TeleopFigures held = runTeleop(trace, over(50.0, PredictorChoice::order0), nullptr);
  const TeleopFigures predicted = runTeleop(trace, over(50.0, PredictorChoice::experts), nullptr);
  // 50 ms, half a period of 10 ms, the smoothing's and the device's own milliseconds.
  EXPECT_GT(held.added_delay_ms, 52.0);
  EXPECT_LT(held.added_delay_ms, 100.0);
  EXPECT_LT(predicted.added_delay_ms, 20.0);
  EXPECT_LT(predicted.rms_error_mm, 0.35 * held.rms_error_mm);
  EXPECT_LT(predicted.orientation_rms_deg, 0.3 * predicted.orientation_held_rms_deg);
  EXPECT_NEAR(held.packets_per_s, 100.0, 1.0);
  EXPECT_LE(held.message_bits, 640.0);
  EXPECT_NEAR(held.linked_share, 1.0 - 0.05 / 6.0, 0.005);
}

TEST(TeleopRun, TheModelGivesNoEnergyAndNoDragAndTheSpringDoes) {
  auto settings = over(100.0, PredictorChoice::order0);
  settings.wall_N_per_m = 500.0;
  const auto trace = swing(20.0, 0.7, 6.0);
  // The round trip is more than half a period: the other end comes when the hand has turned, and pulls along with it.
  const auto quick = swing(20.0, 3.0, 6.0);
  for (const auto& each : {trace, quick}) EXPECT_GE(runTeleop(each, settings, nullptr).least_energy_J, -1e-3);
  settings.coupling = CouplingChoice::spring;
  EXPECT_LT(runTeleop(quick, settings, nullptr).least_energy_J, -0.005);
  settings.wall_N_per_m = 0.0;
  EXPECT_GT(runTeleop(trace, settings, nullptr).drag_N, 0.5);
  settings.coupling = CouplingChoice::model;
  EXPECT_LT(runTeleop(trace, settings, nullptr).drag_N, 0.01);
}

TEST(TeleopRun, TheSameRunGivesTheSameAndAnotherSeedAnother) {
  auto settings = over(40.0, PredictorChoice::experts);
  settings.path.forward.jitter_ms = 20.0;
  settings.path.forward.loss_percent = 20.0;
  const auto trace = swing(25.0, 1.3, 3.0);
  const TeleopFigures one = runTeleop(trace, settings, nullptr), same = runTeleop(trace, settings, nullptr);
  EXPECT_EQ(one.rms_error_mm, same.rms_error_mm);
  EXPECT_EQ(one.jerk_ratio, same.jerk_ratio);
  settings.path.forward.seed = 99;
  EXPECT_NE(runTeleop(trace, settings, nullptr).rms_error_mm, one.rms_error_mm);
}

TEST(TeleopRun, AMotionLargerThanTheWorkspaceIsScaledAndGapsAreCrossed) {
  auto trace = swing(400.0, 0.5, 4.0);
  for (std::size_t i = 1000; i < 1300; ++i) trace.position_mm[i][0] = std::nan("");
  const TeleopFigures out = runTeleop(trace, over(20.0, PredictorChoice::experts), nullptr);
  EXPECT_NEAR(out.scale, 0.9 * 160.0 / 800.0, 0.01);
  EXPECT_TRUE(std::isfinite(out.rms_error_mm));
  EXPECT_NEAR(out.seconds, 4.0, 0.002);
}

TEST(TeleopRun, WhatCannotBeIsRefusedByName) {
  auto settings = over(20.0, PredictorChoice::order0);
  settings.period_ms = 0.0;
  EXPECT_THAT(checkTeleopRun(settings).error().text(), testing::HasSubstr("period 0"));
  settings.period_ms = 10.0;
  settings.wall_N_per_m = -1.0;
  EXPECT_THAT(checkTeleopRun(settings).error().text(), testing::HasSubstr("wall -1"));
  settings.wall_N_per_m = 0.0;
  settings.deadband_percent = 101.0;
  EXPECT_THAT(checkTeleopRun(settings).error().text(), testing::HasSubstr("deadband 101"));
  settings.deadband_percent = 0.0;
  settings.smooth_ms = std::nan("");
  EXPECT_THAT(checkTeleopRun(settings).error().text(), testing::HasSubstr("smoothing nan"));
  settings.smooth_ms.reset();
  settings.path.forward.delay_ms = std::nan("");
  EXPECT_FALSE(checkTeleopRun(settings));
}

}  // namespace
}  // namespace fyd::sim
