// A minimal plant: first-order motors with a speed limit, a cloth S·law(θ), a sensor with dead time and lag. The full
// chain is in core/sim; this one lets core/control be tested alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/control/lag_model.h"
#include "core/control/static_law.h"
#include "core/control/stiffness_controller.h"

namespace fyd::control {

struct BenchPlant {
  double scale = 1.0;
  double place = 1.0;  ///< stiffness at the finger relative to that where the law was measured
  double bias = 1.0;   ///< constant factor of the reading's error
  double delay_s = 0.02;
  double lag_s = 0.02;
  double ripple = 0.0;  ///< relative amplitude of a 7 Hz disturbance of the reading
  double sigma = 0.05;  ///< relative, as reported
  double angle_deg = 20.0;
  double speed_deg_per_s = 180.0;
  double now_s = 100.0;

  [[nodiscard]] double stiffness() const { return place * scale * law.stiffness_N_per_mm(angle_deg).value; }

  ControlInput read(double target) {
    if (first) {
      sensor.configure(delay_s, lag_s);
      sensor.reset(stiffness());
      first = false;
    }
    const double seen = bias * sensor.step(stiffness(), 0.001) * (1 + ripple * std::sin(44 * now_s));
    return {.now = instantAt(now_s),
            .target_N_per_mm = target,
            .measured_N_per_mm = seen,
            .measured_sigma_N_per_mm = sigma * seen,
            .place_factor = place,
            .observable = true,
            .measured_angle_deg = angle_deg,
            .measured_angle_known = true,
            .enabled = true};
  }
  void move(double reference_deg, double dt_s = 0.001) {
    const double reach = speed_deg_per_s * dt_s;
    angle_deg += std::clamp((reference_deg - angle_deg) * dt_s / 0.03, -reach, reach);
    now_s += dt_s;
  }
  /// True stiffness each millisecond.
  std::vector<double> run(StiffnessController& controller, double target, double seconds,
                          ControlOutput* last = nullptr) {
    std::vector<double> course;
    for (int i = 0; i < static_cast<int>(seconds * 1000); ++i) {
      const ControlOutput output = controller.step(read(target));
      move(output.stretch_angle_deg);
      course.push_back(stiffness());
      if (last != nullptr) *last = output;
    }
    return course;
  }

  StaticLaw law;
  LagModel sensor;
  bool first = true;
};

}  // namespace fyd::control
