// Indentation: error against true depth over the whole cloth, and the time of one step.
#include <cmath>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/calibrated_cloth.h"
#include "app/bench/parts/cloths.h"
#include "app/bench/parts/pressed_cloth.h"
#include "app/bench/parts/table.h"
#include "core/sensing/indentation.h"
#include "core/sensing/stiffness_estimator.h"

namespace fyd::bench {
namespace {

struct Method {
  const char* name = "";
  sensing::IndentationMode mode = sensing::IndentationMode::membrane;
  bool with_force = false;
  bool calibrated = false;
};

constexpr Method kMethods[] = {
    {"baseline: thesis plane, gate, 0.8/0.2", sensing::IndentationMode::thesis, false},
    {"membrane and Kalman, distances alone", sensing::IndentationMode::membrane, false},
    {"membrane, Kalman and force", sensing::IndentationMode::membrane, true},
    {"contact and Kalman, distances alone", sensing::IndentationMode::contact, false},
    {"contact, Kalman and force", sensing::IndentationMode::contact, true},
    {"contact and force, cloth calibrated", sensing::IndentationMode::contact, true, true},
};

struct Score {
  double squares = 0.0;
  double worst = 0.0;
  double corner_squares = 0.0;
  double stiffness_squares = 0.0;
  int stiffness_near = 0;  // within 15 %: about what a finger can distinguish
  double sigma_squares = 0.0;
  int asked = 0;
  int samples = 0;  // of those the method says that it knows
  int corner_samples = 0;
  int stiffness_samples = 0;
  std::vector<double> ns;  // of steps with new distances; in the others nothing but the filters' time goes on
};

void press(const PressedClothOptions& options, const sensing::IndentationParameters& parameters, bool with_force,
           bool corner, Score& score) {
  PressedCloth cloth(options);
  sensing::IndentationEstimator estimator(parameters);
  sensing::StiffnessParameters ratio;
  ratio.mode = parameters.mode == sensing::IndentationMode::thesis ? sensing::StiffnessMode::thesis
                                                                   : sensing::StiffnessMode::slope;
  sensing::StiffnessEstimator stiffness(ratio);
  for (int i = 0; i < 2200; ++i) {
    const std::uint64_t readings = cloth.ir.count;
    cloth.step();
    const auto start = std::chrono::steady_clock::now();
    const sensing::IndentationEstimate e =
        estimator.step(cloth.now, cloth.ir, cloth.finger, with_force ? cloth.force_N : Timed<double>{});
    const sensing::StiffnessEstimate k = stiffness.step(cloth.now, cloth.force_N, e);
    const double took_ns = std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
    if (cloth.ir.count != readings) score.ns.push_back(took_ns);
    if (cloth.sinceTouch_s() < 0.1) continue;
    ++score.asked;
    if (!e.available) continue;
    const double error = e.indentation_mm - cloth.depth_mm;
    score.squares += error * error;
    score.sigma_squares += e.sigma_mm * e.sigma_mm;
    score.worst = std::max(score.worst, std::abs(error));
    ++score.samples;
    if (corner) {
      score.corner_squares += error * error;
      ++score.corner_samples;
    }
    if (k.observable && cloth.sinceTouch_s() > 0.6) {
      const double off = k.stiffness_N_per_mm / cloth.stiffness_N_per_mm() - 1.0;
      score.stiffness_squares += off * off;
      score.stiffness_near += std::abs(off) <= 0.15 ? 1 : 0;
      ++score.stiffness_samples;
    }
  }
}

struct Setup {
  sim::ClothKind cloth;
  sim::FingerKind finger;
  double radius_mm;  // of the ideal cloth's disc
  double noise_mV;
  std::string name;
};

std::vector<Setup> setups() {
  std::vector<Setup> out;
  for (const sim::ClothKind cloth : benchCloths()) {
    const std::string name(sim::kClothNames[static_cast<std::size_t>(cloth)]);
    if (cloth == sim::ClothKind::ideal) {
      for (const auto& [noise_mV, radius_mm] : {std::pair{10.0, 7.0}, {10.0, 6.0}, {10.0, 8.0}, {25.0, 7.0}}) {
        out.push_back(
            {cloth, sim::FingerKind::disc, radius_mm, noise_mV, fmt::format("{}, disc {} mm", name, radius_mm)});
      }
      continue;
    }
    for (const auto& [finger, noise_mV] : {std::pair{sim::FingerKind::sphere, 10.0},
                                           {sim::FingerKind::sphere, 25.0},
                                           {sim::FingerKind::capsule, 10.0},
                                           {sim::FingerKind::disc, 10.0}}) {
      const std::string_view pressed_by = sim::kFingerNames[static_cast<std::size_t>(finger)];
      out.push_back({cloth, finger, 7.0, noise_mV, fmt::format("{}, {}", name, pressed_by)});
    }
  }
  return out;
}

sensing::IndentationParameters parametersOf(const Method& method, const Setup& setup) {
  sensing::IndentationParameters parameters;
  if (method.calibrated) {
    parameters = calibratedOn({.cloth = setup.cloth, .finger = setup.finger}).sensing.indentation;
  } else if (setup.cloth == sim::ClothKind::ideal) {
    parameters.camera_height_mm = 10'000;   // the ideal cloth is seen without perspective …
    parameters.contact_radius_share = 1.0;  // … and pressed by a flat disc
  }
  parameters.mode = method.mode;
  parameters.ir_noise_mV = setup.noise_mV;
  return parameters;
}

Score wholeCloth(const Method& method, const Setup& setup) {
  Score score;
  const sensing::IndentationParameters parameters = parametersOf(method, setup);
  const bool ideal = setup.cloth == sim::ClothKind::ideal;
  // Half sides of the area in which the finger presses 8 mm deep clear of the frame, and which its table covers.
  const double width_mm = !ideal && setup.finger == sim::FingerKind::disc ? 38 : 41.5;
  const double depth_mm = ideal || setup.finger == sim::FingerKind::sphere ? 27 : 18;
  std::uint64_t seed = 1;
  const int every = wholeOrQuick(1, 4);
  for (int i = -4; i <= 4; i += every) {
    for (int j = -3; j <= 3; j += wholeOrQuick(1, 3)) {
      for (const double depth : {3.0, 6.0, ideal ? 10.0 : 7.5}) {
        press({.x_mm = width_mm * i / 4,
               .y_mm = depth_mm * j / 3,
               .depth_mm = depth,
               .cloth = setup.cloth,
               .finger = setup.finger,
               .finger_radius_mm = setup.radius_mm,
               .ir_noise_mV = setup.noise_mV,
               .seed = ++seed},
              parameters, method.with_force, std::abs(i) == 4 && std::abs(j) == 3, score);
      }
    }
  }
  return score;
}

}  // namespace

Table bench_indentation() {
  Table table{.subject = "indentation",
              .title = "Indentation and stiffness over the whole cloth",
              .columns = {{"method", Role::method},
                          {"cloth and finger", Role::group},
                          {"IR noise", "mV", Role::group},
                          {"error RMS", "mm", Role::error},
                          "known",
                          "of the thesis' error",
                          {"worst", "mm"},
                          {"corners RMS", "mm"},
                          {"claimed σ RMS", "mm"},
                          {"stiffness error RMS", "%"},
                          "within 15 %",
                          {"step with new distances, p50", "ns", Role::cost},
                          {"p99", "ns"}}};
  const double clock_ns = clockTime_ns();
  for (const Setup& setup : wholeOrFirst(setups(), 1)) {
    double thesis = 0.0;
    for (const Method& method : kMethods) {
      if (method.calibrated && setup.cloth == sim::ClothKind::ideal) continue;
      Score s = wholeCloth(method, setup);
      const double rms = std::sqrt(s.squares / s.samples);
      if (method.mode == sensing::IndentationMode::thesis) thesis = rms;
      const Quantiles t = quantiles(s.ns);
      table.rows.push_back({method.name, setup.name, number(setup.noise_mV), number(rms),
                            fmt::format("{:.1f} %", 100.0 * s.samples / s.asked), number(rms / thesis), number(s.worst),
                            number(std::sqrt(s.corner_squares / s.corner_samples)),
                            number(std::sqrt(s.sigma_squares / s.samples)),
                            number(100 * std::sqrt(s.stiffness_squares / s.stiffness_samples)),
                            fmt::format("{:.0f} %", 100.0 * s.stiffness_near / s.stiffness_samples),
                            number(t.p50 - clock_ns), number(t.p99 - clock_ns)});
    }
  }
  table.notes = {
      "63 places over the cloth as far as the finger keeps off the frame and within its table (±41.5 × ±27 mm; on a "
      "solved cloth a capsule ±41.5 × ±18 mm, a disc ±38 × ±18 mm), depths 3, 6 and 10 mm (7.5 mm on a cloth that is "
      "not ideal), pressed in 0.2 s and held for 1.8 s with "
      "±0.5 mm of slow wander; errors from 0.1 s after the touch, where the method says that it knows (\"known\": the "
      "share of the samples), "
      "stiffness from 0.6 s. Time of a step in which distances came, the clock's own taken off. IR at 60 Hz and "
      "12 bit, camera at 30 Hz with 0.1 mm of noise, force at 122 Hz, 0.6 N/mm.",
      "Truth: membrane and rollers are cloths solved in finite strain, of which the estimators know nothing, pressed "
      "by "
      "a sphere of 8 mm, a tilted capsule or a flat disc of 7 mm. Cloth calibrated: nine presses over the sensors. The "
      "ideal cloth is the formula that the estimators themselves assume, with another finger radius where the column "
      "says so (membrane always assumes 7 mm, contact is told the area and that the finger is flat): those figures "
      "test "
      "the formula against itself."};
  return table;
}

}  // namespace fyd::bench
