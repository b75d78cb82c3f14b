// A stiffness loop on a cloth that is not the calibrated one. Truth: the cloth's own stiffness, a straight line over the
// stretch that the controller knows nothing of, must come to the target.
#include <core/control/stiffness_controller.h>

#include "expect.h"

int main() {
  fyd::control::ControlParameters parameters;
  parameters.measurement_bias = 0.0;  // this sensor is right on average
  fyd::control::StiffnessController controller(parameters);

  double stretch_deg = 30.0, reference_deg = 30.0, seen_N_per_mm = 0.0;
  const auto cloth_N_per_mm = [](double angle_deg) { return 0.52 + 0.0045 * angle_deg; };
  seen_N_per_mm = cloth_N_per_mm(stretch_deg);
  controller.reset(stretch_deg);
  for (int step = 1; step <= 40'000; ++step) {
    constexpr double kStep_s = 0.001, kMotor_s = 0.05, kSensor_s = 0.25;
    stretch_deg += kStep_s / kMotor_s * (reference_deg - stretch_deg);
    seen_N_per_mm += kStep_s / kSensor_s * (cloth_N_per_mm(stretch_deg) - seen_N_per_mm);
    const auto out = controller.step({.now = fyd::Instant(std::chrono::milliseconds(step)),
                                      .target_N_per_mm = step < 20'000 ? 0.75 : 0.85,
                                      .measured_N_per_mm = seen_N_per_mm,
                                      .measured_sigma_N_per_mm = 0.002,
                                      .observable = true,
                                      .measured_angle_deg = stretch_deg,
                                      .measured_angle_known = true,
                                      .enabled = true});
    reference_deg = out.stretch_angle_deg;
    if (step == 19'999) expectNear("the cloth's stiffness, N/mm", cloth_N_per_mm(stretch_deg), 0.75, 0.01);
  }
  expectNear("the cloth's stiffness, N/mm", cloth_N_per_mm(stretch_deg), 0.85, 0.01);

  parameters.kp = 1e9;
  const auto bound = fyd::bindParameters(parameters);
  expect("a gain out of its range is told", !fyd::insideRange(*fyd::findParameter(bound, "control.kp")));
}
