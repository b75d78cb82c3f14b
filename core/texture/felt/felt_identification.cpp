#include "core/texture/felt/felt_identification.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/parameter.h"
#include "core/base/portable_math.h"

namespace fyd::texture {
namespace {

constexpr double kEncoderStep_deg = 360.0 / kSweepCountsPerTurn;
constexpr int kSustainedSamples = 5;  // in which the encoder must stay off its first count to count as motion
constexpr double kCoarsestRamp_percent = 1.0;
constexpr double kLeastStretchSpan_deg = 10.0;
constexpr double kGoodError = 0.3;            // FoundCloth::held_out_error
constexpr double kUsableError = 0.6;          // the same
constexpr double kUsableRelativeSigma = 0.1;  // of the resonance
constexpr double kMostGainRatio = 2.0;        // of two chirps: more, and the sensor or its scale was changed between

/// The only motor that has a duty; −1: none, or both.
int rampedMotor(const SweepPart& part) {
  int motor = -1;
  for (const SweepRow& row : part) {
    for (int i = 0; i < static_cast<int>(kFeltMotors); ++i) {
      if (row.duty_percent[static_cast<std::size_t>(i)] == 0.0) continue;
      if (motor >= 0 && motor != i) return -1;
      motor = i;
    }
  }
  return motor;
}

struct Ramp {
  double breakaway_percent = 0.0;  // signed
  int start_counts = 0;
  double stretch_deg = 0.0;
};

/// first − second, modulo a turn, within ± half a turn.
int countsBetween(int first, int second) {
  return (first - second + kSweepCountsPerTurn + kSweepCountsPerTurn / 2) % kSweepCountsPerTurn -
         kSweepCountsPerTurn / 2;
}

Result<Ramp> readRamp(const SweepPart& part, std::size_t motor, const FeltPlant& base) {
  const auto moved = [&](std::size_t n) {
    return countsBetween(part[n].encoder_counts[motor], part.front().encoder_counts[motor]);
  };
  const double last = part.back().duty_percent[motor];
  double largest = 0.0;
  for (std::size_t n = 1; n < part.size(); ++n) {
    const double duty = part[n].duty_percent[motor];
    const double step = duty - part[n - 1].duty_percent[motor];
    if (duty * last < 0.0 || step * last < 0.0 || std::abs(step) > kCoarsestRamp_percent) {
      return fail("part {}: duty of motor {} goes from {} to {} %: expected a ramp in steps of at most {} %",
                  part.front().part, motor + 1, part[n - 1].duty_percent[motor], duty, kCoarsestRamp_percent);
    }
    largest = std::max(largest, std::abs(duty));
  }
  for (std::size_t n = 0; n + kSustainedSamples <= part.size(); ++n) {
    bool sustained = true;
    for (std::size_t k = n; k < n + kSustainedSamples; ++k) sustained = sustained && moved(k) != 0;
    if (!sustained) continue;
    const double duty = part[n].duty_percent[motor];
    if (duty == 0.0) return fail("part {}: motor {} moves before it has a duty", part.front().part, motor + 1);
    // A creeping motor has moved half a count on average before the count changes, against the position loop, whose
    // duty is subtracted. One that jumps (3 counts within 20 ms) broke away at this duty.
    const std::size_t later = std::min(n + 20, part.size() - 1);
    const bool creeps = std::abs(moved(later)) < 3;
    const double position_loop_percent = creeps ? 0.5 * kEncoderStep_deg * base.position_gain_percent_per_deg : 0.0;
    return Ramp{.breakaway_percent = std::copysign(std::max(std::abs(duty) - position_loop_percent, 0.0), duty),
                .start_counts = part.front().encoder_counts[motor],
                .stretch_deg = part.front().stretch_deg};
  }
  return fail("part {}: motor {} did not turn up to a duty of {} %; expected a ramp until it turns", part.front().part,
              motor + 1, largest);
}

/// Breakaway of a ramp, %, corrected to the motor's position before its first ramp: a motor that stuck off that
/// position is pushed back by the board's position loop, so it needs less duty in one direction and more in the other.
double breakawayFrom(const Ramp& first, const Ramp& ramp, const FeltPlant& base) {
  constexpr double kSameStretch_deg = 3.0;
  const double direction = std::copysign(1.0, ramp.breakaway_percent);
  const double offset_deg = std::abs(ramp.stretch_deg - first.stretch_deg) <= kSameStretch_deg
                                ? kEncoderStep_deg * countsBetween(ramp.start_counts, first.start_counts)
                                : 0.0;
  return std::abs(ramp.breakaway_percent) - direction * offset_deg * base.position_gain_percent_per_deg;
}

double mean(const std::vector<double>& x) {
  double sum = 0.0;
  for (const double v : x) sum += v;
  return sum / static_cast<double>(x.size());
}

Result<std::array<FoundBreakaway, kFeltMotors>> breakaways(
    const std::array<std::array<std::vector<double>, 2>, kFeltMotors>& ramps, const FeltPlant& base) {
  std::array<FoundBreakaway, kFeltMotors> out;
  for (std::size_t i = 0; i < kFeltMotors; ++i) {
    for (std::size_t direction = 0; direction < 2; ++direction) {
      if (ramps[i][direction].empty()) {
        return fail("no ramp of motor {} with {} duty; expected each motor both ways", i + 1,
                    direction == 0 ? std::string_view("+") : std::string_view("-"));
      }
    }
    const double forward = mean(ramps[i][0]);
    const double backward = mean(ramps[i][1]);
    double spread = 0.0;
    double count = 0.0;
    for (std::size_t direction = 0; direction < 2; ++direction) {
      for (const double v : ramps[i][direction]) {
        spread += math::square(v - (direction == 0 ? forward : backward));
        count += 1.0;
      }
    }
    const double scatter = count > 2.0 ? spread / (count - 2.0) / count : 0.0;
    const double quantisation =
        kEncoderStep_deg * base.position_gain_percent_per_deg / std::sqrt(12.0) / std::sqrt(2.0);
    out[i] = {.percent = 0.5 * (forward + backward),
              .sigma_percent = std::sqrt(scatter + quantisation * quantisation),
              .asymmetry_percent = 0.5 * std::abs(forward - backward)};
  }
  return out;
}

}  // namespace

Result<FeltIdentification> identifyPlant(const std::vector<SweepRow>& sweep, const FeltPlant& base) {
  FeltIdentification out;
  out.plant = base;
  std::array<std::array<std::vector<double>, 2>, kFeltMotors> ramps;
  std::array<std::optional<Ramp>, kFeltMotors> first;
  std::vector<const SweepPart*> chirps;
  const std::vector<SweepPart> parts = partsOf(sweep);
  for (const SweepPart& part : parts) {
    if (isChirp(part)) {
      chirps.push_back(&part);
      continue;
    }
    const int motor = rampedMotor(part);
    if (motor < 0) {
      return fail("part {}: neither a ramp of one motor nor a chirp of both with the same duty", part.front().part);
    }
    const auto ramp = readRamp(part, static_cast<std::size_t>(motor), base);
    if (!ramp) return tl::unexpected(ramp.error());
    const auto of = static_cast<std::size_t>(motor);
    if (!first[of]) first[of] = *ramp;
    ramps[of][ramp->breakaway_percent > 0.0 ? 0 : 1].push_back(breakawayFrom(*first[of], *ramp, base));
  }
  const auto found = breakaways(ramps, base);
  if (!found) return tl::unexpected(found.error());
  out.breakaway = *found;
  for (std::size_t i = 0; i < kFeltMotors; ++i) out.plant.breakaway_percent[i] = out.breakaway[i].percent;

  double lowest_deg = std::numeric_limits<double>::infinity();
  double highest_deg = -lowest_deg;
  for (const SweepPart* chirp : chirps) {
    lowest_deg = std::min(lowest_deg, chirp->front().stretch_deg);
    highest_deg = std::max(highest_deg, chirp->front().stretch_deg);
  }
  if (chirps.size() < 2 || highest_deg - lowest_deg < kLeastStretchSpan_deg) {
    return fail("{} chirps, stretches {} ° apart; expected two or more chirps, {} ° apart", chirps.size(),
                chirps.empty() ? 0.0 : highest_deg - lowest_deg, kLeastStretchSpan_deg);
  }
  const auto fitted = fitChirps(chirps, out.plant);
  if (!fitted) return tl::unexpected(fitted.error());
  out.sliding_share = fitted->sliding_share;
  out.cloths = fitted->cloths;

  double stretch = 0.0;
  double resonance = 0.0;
  double damping = 0.0;
  double gain = 0.0;
  double least_gain = std::numeric_limits<double>::infinity();
  double largest_gain = 0.0;
  for (const FoundCloth& cloth : out.cloths) {
    if (!(cloth.held_out_error <= kUsableError)) {
      return fail("part {}: the model leaves {:.0f} % of the acceleration held out; expected at most {:.0f} %",
                  cloth.part, 100.0 * cloth.held_out_error, 100.0 * kUsableError);
    }
    if (!(cloth.sigma_Hz <= kUsableRelativeSigma * cloth.resonance_Hz)) {
      return fail("part {}: resonance {:.1f} ± {:.1f} Hz: not determined; expected ± {:.0f} % or better", cloth.part,
                  cloth.resonance_Hz, cloth.sigma_Hz, 100.0 * kUsableRelativeSigma);
    }
    out.held_out_error = std::max(out.held_out_error, cloth.held_out_error);
    const auto count = static_cast<double>(chirps.size());
    stretch += cloth.stretch_deg / count;
    resonance += cloth.resonance_Hz / count;
    damping += cloth.damping / count;
    const double size = std::abs(cloth.gain);  // its sign says only how the accelerometer lies
    gain += size / count;
    least_gain = std::min(least_gain, size);
    largest_gain = std::max(largest_gain, size);
  }
  if (!(largest_gain <= kMostGainRatio * least_gain)) {
    return fail("gains of the chirps from {:.2f} to {:.2f}; expected them within a factor of {}", least_gain,
                largest_gain, kMostGainRatio);
  }
  double covariance = 0.0;
  double variance = 0.0;
  for (const FoundCloth& cloth : out.cloths) {
    variance += math::square(cloth.stretch_deg - stretch);
    covariance += (cloth.stretch_deg - stretch) * (cloth.resonance_Hz - resonance);
    out.sigma_resonance_Hz = std::max(out.sigma_resonance_Hz, cloth.sigma_Hz);
  }
  out.plant.stretch_deg = stretch;
  out.plant.resonance_Hz = resonance;
  out.plant.damping = damping;
  out.plant.cloth_gain = gain;
  out.plant.resonance_Hz_per_deg = covariance / variance;
  out.plant.identified = true;
  for (const Parameter& each : bindParameters(out.plant)) {
    if (auto checked = checkParameter(each, each.value()); !checked) return tl::unexpected(checked.error());
  }
  out.verdict = out.held_out_error <= kGoodError ? sentence("good") : sentence("usable");
  return out;
}

}  // namespace fyd::texture
