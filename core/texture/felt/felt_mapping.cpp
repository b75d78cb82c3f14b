#include "core/texture/felt/felt_mapping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/portable_math.h"

namespace fyd::texture {
namespace {

// Chosen on random materials and noise bands (seed 2026) at the finger of the plant in tests/cli/felt_peer.py; judged
// on the signals of that test.

constexpr double kLargestSignal_g = 1000.0;
constexpr double kLeak_Hz = 4.0;  // of the integrators: slower motion belongs to the position loop
constexpr double kRetune_Hz = 0.5;

constexpr double kGate_s = 0.025;
constexpr double kGateCloses_s = 0.03;
constexpr double kGatePeak = 4.0;  // times the gate's level: a tap opens it at once

constexpr double kLearning_s = 2.0;
constexpr double kEager = 4.0;     // the weight of the first guess falls with this power of time
constexpr double kGuess_s = 0.05;  // weight of the first guess, in time
constexpr double kBurst = 9.0;    // so that a tap does not change what was learned: largest square, in mean squares …
constexpr double kBegin_s = 0.3;  // … once so much of it is known

constexpr double kUsualLevel_g = 0.1;  // before anything is learned
constexpr double kUsualGain = 2.5;
constexpr double kUsual_Hz = 120.0;

constexpr double kStrongest_g = 2.0;
constexpr double kRange = 4.605170185988091;  // 40 dB in nepers
constexpr double kCompressed = 1.05;          // what it becomes: 9 dB in nepers
constexpr double kEven = 0.15;                // share of that compression which is linear in dB …
constexpr double kConcave = 5.0;              // … the rest grows with this power of the dB below kStrongest_g

constexpr double kFrictionShare = 0.95;  // of the breakaway: a turning motor has less
constexpr double kSoftSign = 0.15;       // of the wanted speed's RMS
constexpr double kLead = 0.2;            // samples by which the wanted speed is ahead of the end of the sample
constexpr double kWarm = 0.85;           // of the limit's square: least heat_, so that a start counts as warm
constexpr double kHeat_s = 1.0;     // far shorter than a motor takes to warm, longer than a surface's own variations
constexpr double kAim = 0.92;       // of the heat limit, friction included
constexpr double kHeadroom = 0.97;  // margin to the limits, because clipping distorts the texture

/// Denormals would cost hundreds of cycles each.
double flushed(double value) { return std::abs(value) < 1e-30 ? 0.0 : value; }

double shareOf(double position_share_percent) {
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
  const bool other_cloth = settings.plant.damping != settings_.plant.damping;
  settings_ = settings;
  if (other_cloth) tune();
}

void FeltMapping::reset() {
  tune();
  inverse_.reset();
  speed_deg_s_ = angle_deg_ = gate_level_ = gate_ = samples_ = 0.0;
  heat_ = warm();
  learned_ = usual();
}

void FeltMapping::tune() {
  tuned_Hz_ = settings_.plant.resonanceAt_Hz(stretch_deg_);
  inverse_.tune(tuned_Hz_, settings_.plant.damping);
}

FeltMapping::Surface FeltMapping::usual() const {
  const double speed_deg_s =
      kUsualLevel_g * kUsualGain * settings_.plant.degreesPerG() / (2.0 * std::numbers::pi * kUsual_Hz);
  return {.level = kUsualLevel_g * kUsualLevel_g,
          .cost = math::square(target_percent(kUsualLevel_g) / kUsualGain),
          .speed = speed_deg_s * speed_deg_s};
}

void FeltMapping::openGate(double signal_g) {
  const double T = 1.0 / rate_Hz_;
  gate_level_ = flushed(gate_level_ + std::min(1.0, T / kGate_s) * (signal_g * signal_g - gate_level_));
  if (!(settings_.gate_g > 0.0)) {
    gate_ = 1.0;
    return;
  }
  const double steady = std::clamp(gate_level_ / (settings_.gate_g * settings_.gate_g) - 1.0, 0.0, 1.0);
  const double tap = std::clamp(std::abs(signal_g) / (kGatePeak * settings_.gate_g) - 1.0, 0.0, 1.0);
  gate_ = std::max({steady, tap, gate_ - T / kGateCloses_s});
}

void FeltMapping::learn(const Surface& squares) {
  const double slow = kLearning_s * rate_Hz_;
  double share = 1.0 / slow;
  double burst = std::numeric_limits<double>::infinity();
  Surface towards = squares;
  if (gate_ <= 0.0) {  // what was touched long ago is forgotten
    samples_ -= samples_ / slow;
    towards = usual();
  } else {
    samples_ = std::min(samples_ + gate_, kEager * slow);
    share = kEager * gate_ / (samples_ + kEager * kGuess_s * rate_Hz_);
    burst = kBurst * std::max(1.0, kEager * kBegin_s * rate_Hz_ / samples_);
  }
  const auto follow = [share, burst](double& mean, double square) {
    mean += share * (std::min(square, burst * mean) - mean);
  };
  follow(learned_.level, towards.level);
  follow(learned_.cost, towards.cost);
  follow(learned_.speed, towards.speed);
}

double FeltMapping::limit_percent() const {
  return kAim * std::min(settings_.rms_limit_percent, settings_.maximum_percent);
}

double FeltMapping::friction_percent(std::size_t motor) const {
  return std::min(kFrictionShare * settings_.plant.breakaway_percent[motor], limit_percent());
}

double FeltMapping::target_percent(double level_g) const {
  const double friction = std::max(friction_percent(0), friction_percent(1));
  const double limit = limit_percent();
  const double most = std::sqrt(std::max(limit * limit - friction * friction, 0.04 * limit * limit));
  const double below = std::clamp(math::log(kStrongest_g / level_g) / kRange, 0.0, 2.0);
  return most * math::exp(-kCompressed * (kEven * below + (1.0 - kEven) * math::pow(below, kConcave)));
}

double FeltMapping::warm() const { return kWarm * math::square(settings_.rms_limit_percent); }

double FeltMapping::gain() const {
  constexpr double kFaintest = 1e-6;  // g and %; a silent surface has neither
  const double learned_g = std::max(std::sqrt(learned_.level), kFaintest);
  const double level_g = settings_.surface_level_g > 0.0 ? settings_.surface_level_g : learned_g;
  const double cost_percent = std::max(std::sqrt(learned_.cost), kFaintest) * level_g / learned_g;
  return settings_.gain * target_percent(level_g) / cost_percent;
}

FeltDuty FeltMapping::step(double signal_g, double position_share_percent) {
  const FeltPlant& plant = settings_.plant;
  const double T = 1.0 / rate_Hz_;
  const double signal = std::isfinite(signal_g) ? std::clamp(signal_g, -kLargestSignal_g, kLargestSignal_g) : 0.0;
  if (!inverse_.gliding() && std::abs(plant.resonanceAt_Hz(stretch_deg_) - tuned_Hz_) > kRetune_Hz) tune();
  openGate(signal);

  const double acceleration = inverse_.step(signal) / plant.cloth_gain * plant.degreesPerG();
  const double leak = std::max(0.0, 1.0 - 2.0 * std::numbers::pi * kLeak_Hz * T);
  speed_deg_s_ = flushed(leak * speed_deg_s_ + T * acceleration);
  angle_deg_ = flushed(leak * angle_deg_ + T * speed_deg_s_);
  const double linear_percent =
      100.0 * (plant.time_constant_ms * 1e-3 * acceleration + speed_deg_s_) / plant.free_speed_deg_s +
      plant.position_gain_percent_per_deg * angle_deg_;
  learn({.level = signal * signal, .cost = linear_percent * linear_percent, .speed = speed_deg_s_ * speed_deg_s_});

  FeltDuty out;
  if (gate_ <= 0.0 || settings_.gain <= 0.0) {
    heat_ -= std::min(1.0, T / kHeat_s) * (heat_ - warm());
    return out;
  }
  const double gain_now = gain();
  out.wanted_g = gate_ * gain_now * signal;
  const double share = shareOf(position_share_percent);
  const double room = kHeadroom * std::max(0.0, std::min(settings_.maximum_percent, 100.0 - share));
  const double turning =
      (speed_deg_s_ + kLead * T * acceleration) / (kSoftSign * std::max(std::sqrt(learned_.speed), 1e-6));
  const double sign = turning / std::sqrt(1.0 + turning * turning);
  const double cool = std::min(1.0, kHeadroom * settings_.rms_limit_percent / std::sqrt(std::max(heat_, 1e-12)));
  double hottest = 0.0;
  for (std::size_t i = 0; i < kFeltMotors; ++i) {
    const double still = std::max(0.0, 1.0 - share / std::max(2.0 * plant.breakaway_percent[i], 1.0));
    const double friction = friction_percent(i) * sign * still * std::min(settings_.gain, 1.0);
    const double wanted = gate_ * (gain_now * linear_percent + friction);
    out.percent[i] = std::clamp(cool * wanted, -room, room);
    out.clipped = out.clipped || std::abs(cool * wanted) > room;
    hottest = std::max(hottest, math::square(std::clamp(wanted, -room, room)));
  }
  heat_ = std::max(heat_ + std::min(1.0, T / kHeat_s) * (hottest - heat_), warm());
  return out;
}

}  // namespace fyd::texture
