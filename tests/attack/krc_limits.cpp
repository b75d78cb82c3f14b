// The robot end against controllers of chance: four ticks, jitter, loss, late messages, pauses, nonsense, lost quality,
// answers not obeyed, limits of any ratio. Judged by what the controller was commanded in its own ticks. Then a day of
// the simulated arm, in which no bound on what a controller measures may fire.
//
//   attack_krc [RUNS] [SEED]     full length: attack_krc 400 1 (400 controllers of 20 s, a day); about three minutes
//   attack_krc 1 SEED            one of them again, with the seed that is printed when its limits were broken
//
// Exits 1 when any were, or a bound fired.
#include <cstdio>
#include <cstdlib>

#include "core/device/robot/fri_check.h"
#include "core/sim/finger_path.h"
#include "core/sim/robot/robot_arm.h"
#include "tests/unit/device/played_krc.h"

namespace {

using namespace fyd;
using namespace fyd::device;

constexpr std::array<double, 4> kTicks_s = {0.001, 0.002, 0.005, 0.01};
constexpr int kFullRuns = 400;
constexpr double kRun_s = 20.0;

struct Chance {
  std::mt19937_64 random;
  double share() { return std::uniform_real_distribution<double>(0.0, 1.0)(random); }
  double between(double low, double high) { return low * std::pow(high / low, share()); }
  bool one(int of) { return random() % static_cast<unsigned>(of) == 0; }
};

struct Worst {
  double speed = 0.0, acceleration = 0.0, jerk = 0.0, travelled_mm = 0.0;
  std::uint64_t ticks = 0, held = 0, impossible = 0, runs = 0;
};

PlayedKrcOptions optionsOf(Chance& chance, double tick_s) {
  PlayedKrcOptions out{.tick_s = tick_s, .seed = chance.random()};
  if (chance.one(4)) out.stated_s = tick_s * chance.between(1.0, 20.0);
  out.in_offset = chance.one(5);
  if (!chance.one(4)) {
    out.delay_s = 0.3 * tick_s * chance.share();
    out.jitter_s = 0.4 * tick_s * chance.share();
    out.loss = 0.03 * chance.share();
    out.late = 0.03 * chance.share();
    out.pause = 0.001 * chance.share();
  }
  if (chance.one(2)) out.nonsense = 0.02 * chance.share();
  if (chance.one(2)) {
    out.limits = {.speed_mm_s = chance.between(5, 1000),
                  .acceleration_mm_s2 = chance.between(100, 1e5),
                  .jerk_mm_s3 = chance.between(5e3, 1e7)};
  }
  return out;
}

bool attack(std::uint64_t seed, double tick_s, Worst& worst) {
  Chance chance{std::mt19937_64(seed)};
  const PlayedKrcOptions options = optionsOf(chance, tick_s);
  FakeKrc krc(options);

  WildTargets targets(options.seed);
  while (krc.time_s() < kRun_s) {
    krc.measurement.quality = chance.one(4) ? protocol::FriQuality::bad : protocol::FriQuality::good;
    krc.answers_obeyed = !chance.one(8);
    krc.run(0.02 + 0.3 * chance.share(), targets);
    krc.measurement.quality = protocol::FriQuality::perfect;
    krc.answers_obeyed = true;
    krc.run(3.0 * chance.share(), targets);
  }
  const auto& j = krc.judgement;
  worst.speed = std::max(worst.speed, j.speed_mm_s / (options.limits.speed_mm_s + krc.resolution(1)));
  worst.acceleration =
      std::max(worst.acceleration, j.acceleration_mm_s2 / (options.limits.acceleration_mm_s2 + krc.resolution(2)));
  worst.jerk = std::max(worst.jerk, j.jerk_mm_s3 / (options.limits.jerk_mm_s3 + krc.resolution(3)));
  worst.travelled_mm += j.travelled_mm;
  worst.ticks += j.ticks;
  worst.held += j.held;
  worst.impossible += krc.fri->counters().impossible;
  ++worst.runs;
  if (krc.violation().empty()) return true;
  std::printf("BROKEN seed %llu tick %g stated %g offset %d loss %g nonsense %g limits %g %g %g: %s\n",
              static_cast<unsigned long long>(seed), tick_s, options.stated_s, static_cast<int>(options.in_offset),
              options.loss, options.nonsense, options.limits.speed_mm_s, options.limits.acceleration_mm_s2,
              options.limits.jerk_mm_s3, krc.violation().c_str());
  return false;
}

/// Measurements as a controller makes them of the simulated arm on a material, led by a finger.
bool aDay(double seconds, sim::Material material, const sim::FingerPath& finger) {
  sim::SimParameters parameters;
  parameters.material = material;
  sim::RobotArm arm(parameters);
  MotionLimiter limiter;
  protocol::FriMeasurement before;
  double largest_apart_mm = 0.0, largest_force_N = 0.0;
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(seconds / 0.005); ++i) {
    const double t_s = 0.005 * static_cast<double>(i);
    const auto state = finger.at(std::fmod(t_s, std::max(finger.duration_s(), 1.0)));
    const Vec3 told = limiter.advance({state.x_mm, state.y_mm, -3.0 * state.indentation_mm}, 0.005);
    const auto readings = arm.exchange(told, instantAt(100.0 + t_s)).value();
    const auto frame = [](const Vec3& mm) {
      return protocol::FriFrame{1, 0,  0,  static_cast<float>(0.5 - 0.001 * mm.y),
                                0, -1, 0,  static_cast<float>(-0.001 * mm.x),
                                0, 0,  -1, static_cast<float>(0.3 + 0.001 * mm.z)};
    };
    protocol::FriMeasurement m;
    m.joints = m.commanded_joints = {0.0F, 0.52F, 0.0F, -1.57F, 0.0F, 1.05F, 0.0F};
    m.frame = frame(readings.position_mm);
    m.commanded_frame = frame(told);
    m.force_torque[2] = static_cast<float>(readings.force_N);
    m.krl.reals[0] = static_cast<float>(readings.acceleration_g.x);
    m.krl.reals[1] = static_cast<float>(readings.acceleration_g.y);
    m.krl.reals[2] = static_cast<float>(readings.acceleration_g.z);
    auto good = checkMeasurement(m);
    if (good && i > 0) good = checkStep(before, m, 1);
    if (!good) {
      std::printf("FIRED after %g s: %s\n", t_s, good.error().text().c_str());
      return false;
    }
    before = m;
    largest_apart_mm = std::max(largest_apart_mm, (told - readings.position_mm).norm());
    largest_force_N = std::max(largest_force_N, readings.force_N);
  }
  std::printf("%.0f s on material %d: no bound fired; apart at most %.1f mm, force at most %.1f N\n", seconds,
              static_cast<int>(material), largest_apart_mm, largest_force_N);
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  const int runs = count > 1 ? std::atoi(arguments[1]) : kFullRuns / 100;
  const std::uint64_t first = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  if (runs < 1) {
    std::fprintf(stderr, "attack_krc: %s runs; expected 1 or more\n", arguments[1]);
    return 2;
  }
  bool good = true;
  std::array<Worst, kTicks_s.size()> worst;
  for (int i = 0; i < runs; ++i) {
    const std::uint64_t seed = first + static_cast<std::uint64_t>(i);
    const std::size_t which = seed % kTicks_s.size();
    good = attack(seed, kTicks_s[which], worst[which]) && good;
  }
  for (std::size_t i = 0; i < kTicks_s.size(); ++i) {
    const Worst& w = worst[i];
    std::printf(
        "tick %2g ms: %llu runs, %llu ticks, %llu stood in motion, %llu impossible measurements, %.0f mm; "
        "largest share of the limit: speed %.4f, acceleration %.4f, jerk %.4f\n",
        1e3 * kTicks_s[i], static_cast<unsigned long long>(w.runs), static_cast<unsigned long long>(w.ticks),
        static_cast<unsigned long long>(w.held), static_cast<unsigned long long>(w.impossible), w.travelled_mm, w.speed,
        w.acceleration, w.jerk);
  }
  const double day_s = kDay_s * runs / kFullRuns;
  const auto hand = sim::FingerPath::fromCsv(FYD_TEST_DATA "/hand_motion/index_tip.csv");
  if (!hand) {
    std::fprintf(stderr, "%s\n", hand.error().text().c_str());
    return 1;
  }
  for (const auto material : {sim::Material::none, static_cast<sim::Material>(sim::kMaterialNames.size() - 1)}) {
    good = aDay(0.25 * day_s, material, sim::FingerPath::demonstration()) && good;
    good = aDay(0.25 * day_s, material, *hand) && good;
  }
  return good ? 0 : 1;
}
