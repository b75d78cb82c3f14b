#include "core/replay/replay_plant.h"

#include <algorithm>
#include <cmath>

#include "core/control/motor_mixing.h"
#include "core/pipeline/tune_sample.h"
#include "core/sensing/load_cell.h"

namespace fyd::replay {
namespace {

constexpr double kStandardGravity_N_per_kg = 9.80665;
constexpr std::size_t kBlock = 1000;
constexpr std::size_t kEvery = 10;  // the fit uses every tenth step

double stretchOf(const std::array<sim::SimulatedMotor, control::kMotorCount>& motors) {
  return 0.5 * (motors[0].angle_deg() - motors[1].angle_deg());
}

}  // namespace

Result<control::IdentifiedCloth> identifyRecordedCloth(const recording::Recording& recording,
                                                       const control::ControlParameters& parameters) {
  std::vector<control::TuneSample> samples;
  std::vector<pipeline::TelemetrySample> block;
  const std::uint64_t rows = recording.info().committed_samples;
  for (std::uint64_t first = 0; first < rows; first += kBlock) {
    block.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kBlock, rows - first)));
    if (auto read = recording.telemetry(first, block); !read) return tl::unexpected(read.error());
    for (std::size_t i = 0; i < block.size(); i += kEvery) {
      const pipeline::TelemetrySample& sample = block[i];
      if (!std::isfinite(sample.stretch_measured_deg)) continue;
      const double time_s = secondsInto(recording.info(), sample.now);
      if (!samples.empty() && time_s <= samples.back().time_s) continue;
      samples.push_back(pipeline::tuneSampleOf(sample, time_s));
    }
  }
  auto cloth = control::identifyCloth(samples, parameters);
  if (!cloth) return fail("closed loop: the recording does not say how the cloth answers: {}", cloth.error().message);
  return cloth;
}

ReplayPlant::ReplayPlant(const control::IdentifiedCloth& cloth, const control::ControlParameters& parameters)
    : law_(parameters), shape_gain_(cloth.shape_gain) {}

double ReplayPlant::forceFactor() const {
  const double recorded = law_.stiffness_N_per_mm(stretchOf(recorded_)).value;
  const double replayed = law_.stiffness_N_per_mm(stretchOf(replayed_)).value;
  return recorded > 0.0 && replayed > 0.0 ? std::pow(replayed / recorded, shape_gain_) : 1.0;
}

void ReplayPlant::answer(pipeline::Inputs& inputs, const pipeline::Parameters& present) {
  const control::ControlParameters& control = present.control;
  if (!standing_ && inputs.motors.count > 0) {
    const control::RollerAngles rollers = control::rollerAngles(inputs.motors.value, control);
    standing_ = rollers.valid;
    const std::array<double, control::kMotorCount> angles{rollers.translation_deg + rollers.stretch_deg,
                                                          rollers.translation_deg - rollers.stretch_deg};
    for (std::size_t i = 0; i < control::kMotorCount; ++i) {
      recorded_[i] = replayed_[i] = sim::SimulatedMotor(angles[i]);
    }
  }
  const std::array<bool, control::kMotorCount> inverted{control.encoder_first_inverted,
                                                        control.encoder_second_inverted};
  for (std::size_t i = 0; i < control::kMotorCount; ++i) {
    const double apart_deg = replayed_[i].angle_deg() - recorded_[i].angle_deg();
    const int counts = static_cast<int>(std::lround(apart_deg * control::kEncoderCountsPerDegree));
    std::uint16_t& encoder = inputs.motors.value.encoder_counts[i];
    if (encoder >= control::kEncoderCountsPerTurn) continue;  // a reading that was invalid stays so
    const int turned = (encoder + (inverted[i] ? -counts : counts)) % control::kEncoderCountsPerTurn;
    encoder = static_cast<std::uint16_t>((turned + control::kEncoderCountsPerTurn) % control::kEncoderCountsPerTurn);
  }
  if (inputs.bridge.count != bridge_seen_) {
    bridge_seen_ = inputs.bridge.count;
    factor_ = inputs.finger.value.contact ? forceFactor() : 1.0;
  }
  const sensing::LoadCellParameters& cell = present.sensing.load_cell;
  const double force_N = sensing::LoadCell(cell).force_N(inputs.bridge.value.value_mV_per_V);
  const double slope_N = cell.slope_g_per_mV_per_V * 1e-3 * kStandardGravity_N_per_kg;
  if (factor_ == 1.0 || !std::isfinite(force_N) || slope_N == 0.0) return;
  inputs.bridge.value.value_mV_per_V += force_N * (factor_ - 1.0) / slope_N;
}

void ReplayPlant::follow(const control::MotorCommand& recorded, const control::MotorCommand& replayed,
                         double elapsed_s) {
  const sim::MotorLimits limits;
  const auto drive = [&](Motors& motors, const control::MotorCommand& command) {
    for (std::size_t i = 0; i < control::kMotorCount; ++i) {
      motors[i].step(command.reference_ticks[i] / control::kTicksPerDegree, command.vibration_duty_percent[i],
                     command.active, limits, elapsed_s);
    }
  };
  drive(recorded_, recorded);
  drive(replayed_, replayed);
}

}  // namespace fyd::replay
