#include "core/texture/felt/felt_mapping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/portable_math.h"

namespace fyd::texture {
namespace {

// Tuned on random materials and noise bands (seed 2026) with the simulated plant of tests/cli/felt_plant.cpp, and
// evaluated on the signals of felt_peer.py beside it.

constexpr double kLargestSignal_g = 1000.0;
constexpr double kIntegratorLeak_Hz = 4.0;  // slower motion is left to the position loop
constexpr double kRetune_Hz = 0.5;          // shift of the resonance that needs a new inverse filter

constexpr double kGateAveraging_s = 0.025;
constexpr double kGateRelease_s = 0.03;  // from open to closed
constexpr double kGateTapRatio = 4.0;    // a sample above this times the threshold starts to open the gate at once

constexpr double kLearningTimeConstant_s = 2.0;
constexpr double kInitialDecayExponent = 4.0;  // the initial values' weight falls with this power of the time of touch
constexpr double kInitialWeight_s = 0.05;      // time of touch that the initial values count for
// A square counts at most kOutlierRatio times the running mean, so that a single tap does not change the estimate. The
// limit is wider at first: it is reached after kInitialDecayExponent · kOutlierOnset_s of touch.
constexpr double kOutlierRatio = 9.0;
constexpr double kOutlierOnset_s = 0.3;
constexpr double kLeastRms = 1e-6;  // g, % and °/s: a mean of nothing is neither divided by nor multiplied

// Surface that is assumed before anything is estimated.
constexpr double kInitialLevel_g = 0.1;
constexpr double kInitialGain = 2.5;
constexpr double kInitialFrequency_Hz = 120.0;

// Compression: 40 dB of signal below kFullDutyLevel_g become 9 dB of duty.
constexpr double kFullDutyLevel_g = 2.0;              // RMS signal that gets the largest duty
constexpr double kInputRange_Np = 4.605170185988091;  // 40 dB in nepers
constexpr double kOutputRange_Np = 1.05;              // 9 dB in nepers
constexpr double kLinearShare = 0.15;                 // share of the output range that is linear in dB of the input …
constexpr double kCompressionExponent = 5.0;          // … the rest falls with this power of the dB below full duty

constexpr double kFrictionCompensation = 0.95;  // of the breakaway duty: sliding friction is less than static
constexpr double kSoftSignWidth = 0.15;         // of the wanted speed's RMS
constexpr double kSpeedLead_samples = 0.2;      // extrapolation of the wanted speed before its soft sign is taken
constexpr double kLeastHeatShare = 0.85;        // lower bound of heat_percent2_, of the RMS limit's square: after a
                                                // pause the heat limit acts as on a warm motor
constexpr double kHeatAveraging_s = 1.0;  // far shorter than a motor's thermal time constant, longer than a surface's
                                          // own variations
constexpr double kRmsTargetShare = 0.92;  // of the limits, friction compensation included
constexpr double kHeadroom = 0.97;        // margin to the limits, because clipping distorts the texture

/// 0 for tiny values: denormal numbers would cost hundreds of processor cycles each.
double flushedToZero(double value) { return std::abs(value) < 1e-30 ? 0.0 : value; }

/// Magnitude of the position loop's duty, 0 … 100.
double positionDuty_percent(double position_share_percent) {
  return std::isfinite(position_share_percent) ? std::min(std::abs(position_share_percent), 100.0) : 0.0;
}

}  // namespace

FeltMapping::FeltMapping(const FeltSettings& settings, double sample_rate_Hz)
    : settings_(settings),
      rate_Hz_(sample_rate_Hz),
      stretch_deg_(std::numeric_limits<double>::quiet_NaN()),
      inverse_(sample_rate_Hz) {
  reset();
}

void FeltMapping::configure(const FeltSettings& settings) {
  const bool damping_changed = settings.plant.damping != settings_.plant.damping;
  settings_ = settings;
  if (damping_changed) tune();
}

void FeltMapping::reset() {
  tune();
  inverse_.reset();
  speed_deg_s_ = angle_deg_ = gate_mean_square_ = gate_gain_ = samples_ = 0.0;
  heat_percent2_ = leastHeat_percent2();
  learned_ = initialMeanSquares();
}

void FeltMapping::tune() {
  tuned_Hz_ = settings_.plant.resonanceAt_Hz(stretch_deg_);
  inverse_.tune(tuned_Hz_, settings_.plant.damping);
}

FeltMapping::MeanSquares FeltMapping::initialMeanSquares() const {
  const double speed_deg_s = kInitialLevel_g * kInitialGain * settings_.plant.rollerAccelerationPerG_deg_s2() /
                             (2.0 * std::numbers::pi * kInitialFrequency_Hz);
  return {.signal = kInitialLevel_g * kInitialLevel_g,
          .duty = math::square(linearRms_percent(kInitialLevel_g) / kInitialGain),
          .speed = speed_deg_s * speed_deg_s};
}

void FeltMapping::updateGate(double signal_g) {
  const double T = 1.0 / rate_Hz_;
  gate_mean_square_ = flushedToZero(gate_mean_square_ +
                                    std::min(1.0, T / kGateAveraging_s) * (signal_g * signal_g - gate_mean_square_));
  if (!(settings_.gate_g > 0.0)) {
    gate_gain_ = gate_mean_square_ > 0.0 ? 1.0 : 0.0;  // silence teaches nothing about a surface
    return;
  }
  const double steady = std::clamp(gate_mean_square_ / (settings_.gate_g * settings_.gate_g) - 1.0, 0.0, 1.0);
  const double tap = std::clamp(std::abs(signal_g) / (kGateTapRatio * settings_.gate_g) - 1.0, 0.0, 1.0);
  gate_gain_ = std::max({steady, tap, gate_gain_ - T / kGateRelease_s});
}

void FeltMapping::learn(const MeanSquares& squares) {
  const double time_constant_samples = kLearningTimeConstant_s * rate_Hz_;
  double weight = 1.0 / time_constant_samples;
  double outlier_limit = std::numeric_limits<double>::infinity();
  MeanSquares target = squares;
  if (gate_gain_ <= 0.0) {  // not touched: decay to the initial values
    samples_ -= samples_ / time_constant_samples;
    target = initialMeanSquares();
  } else {
    samples_ = std::min(samples_ + gate_gain_, kInitialDecayExponent * time_constant_samples);
    weight = kInitialDecayExponent * gate_gain_ / (samples_ + kInitialDecayExponent * kInitialWeight_s * rate_Hz_);
    outlier_limit = kOutlierRatio * std::max(1.0, kInitialDecayExponent * kOutlierOnset_s * rate_Hz_ / samples_);
  }
  const auto update = [weight, outlier_limit](double& mean, double square) {
    mean += weight * (std::min(square, outlier_limit * std::max(mean, kLeastRms * kLeastRms)) - mean);
  };
  update(learned_.signal, target.signal);
  update(learned_.duty, target.duty);
  update(learned_.speed, target.speed);
}

double FeltMapping::rmsTarget_percent() const {
  return kRmsTargetShare * std::min(settings_.rms_limit_percent, settings_.maximum_percent);
}

double FeltMapping::friction_percent(std::size_t motor) const {
  return std::min(kFrictionCompensation * settings_.plant.breakaway_percent[motor], rmsTarget_percent());
}

double FeltMapping::linearRms_percent(double level_g) const {
  const double friction = std::max(friction_percent(0), friction_percent(1));
  const double limit = rmsTarget_percent();
  const double largest_percent = std::sqrt(std::max(limit * limit - friction * friction, 0.04 * limit * limit));
  const double input_share = std::clamp(math::log(kFullDutyLevel_g / level_g) / kInputRange_Np, 0.0, 2.0);
  return largest_percent *
         math::exp(-kOutputRange_Np *
                   (kLinearShare * input_share + (1.0 - kLinearShare) * math::pow(input_share, kCompressionExponent)));
}

double FeltMapping::leastHeat_percent2() const { return kLeastHeatShare * math::square(settings_.rms_limit_percent); }

double FeltMapping::gain() const {
  const double learned_g = std::max(std::sqrt(learned_.signal), kLeastRms);
  const double level_g = settings_.surface_level_g > 0.0 ? settings_.surface_level_g : learned_g;
  const double duty_percent = std::max(std::sqrt(learned_.duty), kLeastRms) * level_g / learned_g;
  return settings_.gain * linearRms_percent(level_g) / duty_percent;
}

FeltDuty FeltMapping::step(double signal_g, double position_share_percent) {
  const FeltPlant& plant = settings_.plant;
  const double T = 1.0 / rate_Hz_;
  const double signal = std::isfinite(signal_g) ? std::clamp(signal_g, -kLargestSignal_g, kLargestSignal_g) : 0.0;
  if (!inverse_.inTransition() && std::abs(plant.resonanceAt_Hz(stretch_deg_) - tuned_Hz_) > kRetune_Hz) tune();
  updateGate(signal);

  const double acceleration = inverse_.step(signal) / plant.cloth_gain * plant.rollerAccelerationPerG_deg_s2();
  const double leak = std::max(0.0, 1.0 - 2.0 * std::numbers::pi * kIntegratorLeak_Hz * T);
  speed_deg_s_ = flushedToZero(leak * speed_deg_s_ + T * acceleration);
  angle_deg_ = flushedToZero(leak * angle_deg_ + T * speed_deg_s_);
  const double linear_percent =
      100.0 * (plant.time_constant_ms * 1e-3 * acceleration + speed_deg_s_) / plant.free_speed_deg_s +
      plant.position_gain_percent_per_deg * angle_deg_;
  learn({.signal = signal * signal, .duty = linear_percent * linear_percent, .speed = speed_deg_s_ * speed_deg_s_});

  FeltDuty out;
  if (gate_gain_ <= 0.0 || settings_.gain <= 0.0) {
    heat_percent2_ -= std::min(1.0, T / kHeatAveraging_s) * (heat_percent2_ - leastHeat_percent2());
    return out;
  }
  const double gain_now = gain();
  out.wanted_g = gate_gain_ * gain_now * signal;
  const double position_percent = positionDuty_percent(position_share_percent);
  const double largest_duty = kHeadroom * std::max(0.0, std::min(settings_.maximum_percent, 100.0 - position_percent));
  const double relative_speed = (speed_deg_s_ + kSpeedLead_samples * T * acceleration) /
                                (kSoftSignWidth * std::max(std::sqrt(learned_.speed), kLeastRms));
  const double soft_sign = relative_speed / std::sqrt(1.0 + relative_speed * relative_speed);
  const double heat_gain =
      std::min(1.0, kHeadroom * settings_.rms_limit_percent / std::sqrt(std::max(heat_percent2_, 1e-12)));
  double largest_square = 0.0;
  for (std::size_t i = 0; i < kFeltMotors; ++i) {
    const double friction_fade =
        std::max(0.0, 1.0 - position_percent / std::max(2.0 * plant.breakaway_percent[i], 1.0));
    const double friction = friction_percent(i) * soft_sign * friction_fade * std::min(settings_.gain, 1.0);
    const double wanted = gate_gain_ * (gain_now * linear_percent + friction);
    out.percent[i] = std::clamp(heat_gain * wanted, -largest_duty, largest_duty);
    out.clipped = out.clipped || std::abs(heat_gain * wanted) > largest_duty;
    largest_square = std::max(largest_square, math::square(std::clamp(wanted, -largest_duty, largest_duty)));
  }
  heat_percent2_ = std::max(heat_percent2_ + std::min(1.0, T / kHeatAveraging_s) * (largest_square - heat_percent2_),
                            leastHeat_percent2());
  return out;
}

}  // namespace fyd::texture
