// fyd bench touchpad_coupling: what a finger on the simulated touchpad feels of a robot behind a network, by each
// coupling: the step, the simulated cloth, its motors and sensors, in virtual time, on the simulation's truth.
#include <array>
#include <cmath>
#include <deque>
#include <random>
#include <vector>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/table.h"
#include "core/sim/touchpad/lockstep.h"

namespace fyd::bench {
namespace {

using teleop::TouchpadCouplingChoice;

constexpr double kSoft_N_per_mm = 0.60, kStiff_N_per_mm = 0.80;  // both within the cloth's range
constexpr double kDepth_mm = 6.0, kReach_mm = 15.0, kStroke_s = 0.2;
constexpr double kPress_s = 1.5, kChange_s = 3.0, kLift_s = 5.0, kAgain_s = 6.0, kEnd_s = 8.0;
constexpr double kLinkJitter_s = 0.010, kLoss = 0.2;
constexpr int kTellEvery = 10;  // ms

/// How the touched object changes while the finger presses it.
enum class WallKind { stays, stiffens, softens, slides };

double wall(WallKind what, double t_s, double x_mm) {
  switch (what) {
    case WallKind::stays: return kStiff_N_per_mm;
    case WallKind::stiffens: return t_s < kChange_s ? kSoft_N_per_mm : kStiff_N_per_mm;
    case WallKind::softens: return t_s < kChange_s ? kStiff_N_per_mm : kSoft_N_per_mm;
    case WallKind::slides: return x_mm < 0.0 ? kSoft_N_per_mm : kStiff_N_per_mm;
  }
  return 0.0;
}

/// Two presses of 6 mm; during the first one the finger may slide at 50 mm/s across x = 0 at kChange_s.
sim::FingerPath pressTwice(WallKind what) {
  const double from_mm = what == WallKind::slides ? -kReach_mm : 0.0, to_mm = -from_mm, slide_s = kReach_mm / 50.0;
  const auto at = [](double t, double x, double depth) {
    return sim::FingerPath::Knot{t, {.x_mm = x, .y_mm = 0.0, .indentation_mm = depth, .lifted = depth <= 0.0}};
  };
  constexpr double kJust_mm = 1e-3, kMoment_s = 1e-3;
  return sim::FingerPath::fromKnots(
      {at(0.0, from_mm, 0.0), at(kPress_s - kMoment_s, from_mm, 0.0), at(kPress_s, from_mm, kJust_mm),
       at(kPress_s + kStroke_s, from_mm, kDepth_mm), at(kChange_s - slide_s, from_mm, kDepth_mm),
       at(kChange_s + slide_s, to_mm, kDepth_mm), at(kLift_s, to_mm, kDepth_mm),
       at(kLift_s + kStroke_s, to_mm, kJust_mm), at(kLift_s + kStroke_s + kMoment_s, to_mm, 0.0),
       at(kAgain_s - kMoment_s, to_mm, 0.0), at(kAgain_s, to_mm, kJust_mm), at(kAgain_s + kStroke_s, to_mm, kDepth_mm),
       at(kEnd_s, to_mm, kDepth_mm)});
}

struct Figures {
  double least_mJ = 0.0;            // put in by the finger, of each touch
  double felt_s = pipeline::kNone;  // from the change until half of it is felt during that touch
  double second_off_percent = 0.0;  // mean distance of the second press from what the robot touches
};

Figures press(TouchpadCouplingChoice coupling, WallKind what, double delay_s, std::uint64_t seed) {
  sim::LockstepOptions options;
  options.parameters.step.coupling = coupling;
  options.parameters.step.absolute_motion = true;  // the robot is where the finger is
  options.finger = pressTwice(what);
  options.draw_pictures = false;
  options.robot_stiffness_N_per_mm = wall(what, 0.0, -kReach_mm);
  sim::Lockstep lockstep(options);

  struct UnderWay {
    double due_s;
    pipeline::RobotState state;
  };
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::deque<Vec3> touches;  // in transit to the robot
  std::deque<UnderWay> states;
  Timed<pipeline::RobotState> heard;
  lockstep.spoil = [&](pipeline::Inputs& in) { in.robot.state = heard; };

  Figures out;
  double energy_mJ = 0.0, last_mm = 0.0, last_N = 0.0, off = 0.0;
  int in_second = 0;
  bool before = false;
  const bool stiffer = what != WallKind::softens;
  constexpr double kHalf = 0.5 * (kSoft_N_per_mm + kStiff_N_per_mm);
  const auto late = static_cast<std::size_t>(std::lround(1e3 * delay_s));
  for (int i = 0; i < static_cast<int>(1e3 * kEnd_s); ++i) {
    const double t_s = 1e-3 * i;
    if (i == 1000) (void)lockstep.next.commands.push({.action = pipeline::OperatorAction::arm});
    const pipeline::Outputs& outputs = lockstep.step();
    touches.push_back(outputs.touch.position_mm);
    if (touches.size() > late + 1) touches.pop_front();
    if (i % kTellEvery == 0) {
      const Vec3 tool_mm = touches.front();
      const double k = wall(what, t_s, tool_mm.x);
      const double due_s = t_s + delay_s + kLinkJitter_s * uniform(random);
      // In order, as both protocols deliver them.
      if (uniform(random) >= kLoss && (states.empty() || due_s >= states.back().due_s)) {
        states.push_back(
            {due_s, {.stiffness_N_per_mm = k, .position_mm = tool_mm, .force_N = k * std::max(0.0, -tool_mm.z)}});
      }
    }
    while (!states.empty() && states.front().due_s <= t_s) {
      heard.set(states.front().state, lockstep.next.now);
      states.pop_front();
    }

    const sim::WorldSnapshot truth = lockstep.world().truth();
    const double depth_mm = truth.finger.lifted ? 0.0 : truth.finger.indentation_mm;
    const double force_N = truth.finger.lifted ? 0.0 : truth.force_N;
    if (depth_mm > 0.0 && last_mm <= 0.0) energy_mJ = 0.0;
    energy_mJ += 0.5 * (force_N + last_N) * (depth_mm - last_mm);
    last_mm = depth_mm;
    last_N = force_N;
    out.least_mJ = std::min(out.least_mJ, energy_mJ);
    const double k = truth.stiffness_N_per_mm;
    const bool felt = stiffer ? k > kHalf : k < kHalf;
    if (t_s <= kChange_s) before = felt;
    if (what != WallKind::stays && !before && std::isnan(out.felt_s) && t_s > kChange_s && t_s < kLift_s && felt) {
      out.felt_s = t_s - kChange_s;
    }
    if (t_s > kAgain_s + kStroke_s) {
      off += std::abs(k / wall(what, t_s, kReach_mm) - 1.0);
      ++in_second;
    }
  }
  out.second_off_percent = 100.0 * off / in_second;
  return out;
}

}  // namespace

Table bench_touchpad_coupling() {
  Table table;
  table.subject = "touchpad_coupling";
  table.title = "Coupling of the touchpad: what a finger feels of a robot behind a network";
  table.columns = {{"coupling", Role::method},
                   {"one way", "ms", Role::group},
                   {"least energy, stays", "mJ"},
                   {"stiffens", "mJ"},
                   {"softens", "mJ"},
                   {"slides", "mJ"},
                   {"second press off", "%", Role::error},
                   {"until felt, stiffens", "ms"},
                   {"until felt, softens", "ms"},
                   {"until felt, slides", "ms"}};
  for (const auto choice : {TouchpadCouplingChoice::direct, TouchpadCouplingChoice::spring,
                            TouchpadCouplingChoice::tdpa, TouchpadCouplingChoice::model}) {
    for (const int delay_ms : wholeOrFirst(std::vector<int>{0, 50, 200}, 1)) {
      const auto run = [&](WallKind what) { return press(choice, what, 1e-3 * delay_ms, benchOptions().seed); };
      const Figures stays = run(WallKind::stays), stiffens = run(WallKind::stiffens), softens = run(WallKind::softens),
                    slides = run(WallKind::slides);
      const auto felt = [](const Figures& f) { return number(1e3 * f.felt_s); };
      table.rows.push_back({std::string(teleop::kTouchpadCouplingNames[static_cast<std::size_t>(choice)]) +
                                (choice == TouchpadCouplingChoice::direct ? " (baseline)" : ""),
                            std::to_string(delay_ms), number(stays.least_mJ), number(stiffens.least_mJ),
                            number(softens.least_mJ), number(slides.least_mJ), number(stays.second_off_percent),
                            felt(stiffens), felt(softens), felt(slides)});
    }
  }
  table.notes = {
      fmt::format(
          "Presses of {:g} mm, twice; the robot's tool is where the finger was, its surface between {:g} and {:g} "
          "N/mm stays, changes {:g} s after the beginning of the first press, or lies across a slide at 50 mm/s. "
          "A message each 10 ms, jitter to 10 ms, 20 % lost; seed {}.",
          kDepth_mm, kSoft_N_per_mm, kStiff_N_per_mm, kChange_s - kPress_s, benchOptions().seed),
      "Energy, stiffness and times are the simulated cloth's; until felt: half of the change, during that press; —: "
      "not before the next one, or it was so already. The motors' way is in each of them. Nobody felt it."};
  return table;
}

}  // namespace fyd::bench
