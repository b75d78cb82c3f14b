#include "core/sim/touchpad/vibration_sweep.h"

#include <cmath>
#include <random>

#include "core/sim/touchpad/finger_vibration.h"

namespace fyd::sim {

std::vector<texture::SweepRow> simulatedSweep(const FingerVibrationParameters& parameters, device::DeviceTest test,
                                              double stretch_deg, std::uint64_t seed) {
  constexpr double kNoise_g = 0.002;
  constexpr Duration kSweepStep = std::chrono::milliseconds(1);
  const auto motion = device::TestMotion::plan(test, {stretch_deg, -stretch_deg}, std::abs(stretch_deg), stretch_deg);
  std::vector<texture::SweepRow> out;
  if (!motion) return out;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0.0, kNoise_g);
  FingerVibration vibration(parameters, stretch_deg);
  for (Duration at{}; at < motion->length(); at += kSweepStep) {
    const auto command = motion->at(at);
    if (!command) break;
    const auto before = vibration.motor_deg();  // the encoders are read before the duty acts
    const double felt_g = vibration.step(command->vibration_duty_percent);
    const int experiment = motion->experimentAt(at);
    if (experiment == 0) continue;
    texture::SweepRow row{.t_s = toSeconds(at), .part = experiment, .stretch_deg = stretch_deg};
    row.duty_percent = command->vibration_duty_percent;
    for (std::size_t i = 0; i < row.encoder_counts.size(); ++i) {
      const double turns = before[i] / 360.0;
      row.encoder_counts[i] =
          static_cast<int>((turns - std::floor(turns)) * texture::kSweepCountsPerTurn) % texture::kSweepCountsPerTurn;
    }
    row.acceleration_g = felt_g + noise(random);
    out.push_back(row);
  }
  return out;
}

}  // namespace fyd::sim
