#include "app/bench/parts/coupling_run.h"

#include "core/teleop/coupling/coupling_choice.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace fyd::bench {
namespace {

using namespace teleop;

constexpr double kRunStep_s = 0.001;
constexpr int kParts = 10;         // of a step, for the mechanics
constexpr int kMessageEvery = 10;  // steps
constexpr double kWall_m = 0.050, kDepth_m = 0.020, kWiggle_m = 0.030;
constexpr double kWallDamping_N_s_per_m = 1.0;
constexpr double kFar_kg = 0.5;
constexpr double kDiverged_m = 10.0;
constexpr double kForceNoise_N = 0.02, kPositionNoise_m = 5e-6;
// Times and durations of the hand's actions, s.
constexpr double kFree = 1.5, kPress = 1.2, kFirst = kFree, kRelease = 7.0, kSecond = 11.0, kEnd = 15.0;

double uniform(std::mt19937_64& random, double from, double to) {
  return from + (to - from) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

/// Minimum-jerk profile from 0 to 1.
double smooth(double part) {
  const double u = std::clamp(part, 0.0, 1.0);
  return u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
}

double wanted(double t) {
  if (t < kFree) return kWiggle_m * (smooth(t / (kFree / 2)) - smooth((t - kFree / 2) / (kFree / 2)));
  const double deep = kWall_m + kDepth_m;
  return deep * (smooth((t - kFirst) / kPress) - smooth((t - kRelease) / kPress) + smooth((t - kSecond) / kPress));
}

class Way {
 public:
  Way(const CouplingRun& run, std::uint64_t seed) : run_(run), random_(seed) {}
  void send(double now, const CouplingMessage& message) {
    const double arrives = now + run_.delay_s + uniform(random_, 0.0, run_.jitter_s);
    if (uniform(random_, 0.0, 1.0) >= run_.loss) under_way_.emplace_back(arrives, message);
  }
  void deliver(double now, CouplingEnd& to) {
    std::erase_if(under_way_, [&](const auto& each) {
      if (each.first > now + 1e-9) return false;
      to.receive(each.second);
      return true;
    });
  }

 private:
  CouplingRun run_;
  std::mt19937_64 random_;
  std::vector<std::pair<double, CouplingMessage>> under_way_;
};

}  // namespace

CouplingRun drawCouplingRun(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  CouplingRun out;
  out.delay_s = uniform(random, 0.0, 0.7);
  out.jitter_s = uniform(random, 0.0, 0.05);
  out.wall_N_per_m = 50.0 * std::pow(100.0, uniform(random, 0.0, 1.0));
  out.hand_kg = uniform(random, 0.5, 1.5);
  out.hand_N_s_per_m = uniform(random, 2.0, 10.0);
  out.hand_N_per_m = uniform(random, 100.0, 500.0);
  out.seed = seed;
  return out;
}

CouplingFigures simulate(const CouplingRun& run, CouplingChoice choice, std::vector<CouplingRow>* rows) {
  const auto hand_end = makeHandEnd(choice, {});
  const auto far_end = makeFarEnd(choice, {});
  Way there(run, 2 * run.seed + 1), back(run, 2 * run.seed + 2);
  std::mt19937_64 random(run.seed);
  std::normal_distribution<double> noise;
  double hand_m = 0.0, hand_v = 0.0, far_m = 0.0, far_v = 0.0, wall_N = 0.0, energy_J = 0.0;
  double lowest = 1e9, highest = -1e9, felt_N = 0.0, felt_m = 0.0;
  int felt = 0;
  CouplingFigures out;
  out.rest_difference_mm = 1e3 * kDiverged_m;  // of a run that does not come so far: it diverged
  const int steps = static_cast<int>(std::lround(kEnd / kRunStep_s));
  for (int i = 0; i < steps; ++i) {
    const double t = i * kRunStep_s;
    there.deliver(t, *far_end);
    back.deliver(t, *hand_end);
    const double hand_N = hand_end->step({.time_s = t, .position_m = hand_m, .velocity_m_per_s = hand_v});
    const double far_N = far_end->step({.time_s = t,
                                        .position_m = far_m + kPositionNoise_m * noise(random),
                                        .velocity_m_per_s = far_v,
                                        .measured_N = wall_N + kForceNoise_N * noise(random)});
    if (i % kMessageEvery == 0) {
      there.send(t, hand_end->message());
      back.send(t, far_end->message());
    }
    if (rows) rows->push_back({t, hand_m, hand_v, hand_N, far_m, wall_N});
    energy_J += hand_N * hand_v * kRunStep_s;
    out.least_energy_J = std::min(out.least_energy_J, energy_J);
    if (t < kFree) out.drag_N = std::max(out.drag_N, std::abs(hand_N));
    if (t >= kRelease - 1.0 && t < kRelease) {
      lowest = std::min(lowest, hand_m);
      highest = std::max(highest, hand_m);
    }
    if (i == static_cast<int>(std::lround((kSecond - 0.01) / kRunStep_s))) {
      out.rest_difference_mm = 1e3 * std::abs(hand_m - far_m);
    }
    if (t >= kEnd - 0.5) {
      felt_N += hand_N;
      felt_m += hand_m - kWall_m;
      ++felt;
    }
    for (int part = 0; part < kParts; ++part) {
      const double dt = kRunStep_s / kParts, now = t + part * dt;
      const double want_m = wanted(now), want_v = (wanted(now + 1e-5) - wanted(now - 1e-5)) / 2e-5;
      const double arm_N = run.hand_N_per_m * (want_m - hand_m) + run.hand_N_s_per_m * (want_v - hand_v);
      hand_v += dt * (arm_N - hand_N) / run.hand_kg;
      hand_m += dt * hand_v;
      const double deep = far_m - kWall_m;
      wall_N = deep > 0.0 ? std::max(0.0, run.wall_N_per_m * deep + kWallDamping_N_s_per_m * far_v) : 0.0;
      far_v += dt * (far_N - wall_N) / kFar_kg;
      far_m += dt * far_v;
    }
    if (std::abs(hand_m) > kDiverged_m) break;
  }
  out.oscillation_mm = highest >= lowest ? 1e3 * (highest - lowest) : 1e3 * kDiverged_m;
  out.felt_share = felt > 0 && felt_m > 0.0 ? felt_N / felt_m / run.wall_N_per_m : 0.0;
  out.dissipated_J = hand_end->telemetry().dissipated_J + far_end->telemetry().dissipated_J;
  out.unstable = out.oscillation_mm > 20.0 || out.least_energy_J < -0.1;
  return out;
}

}  // namespace fyd::bench
