#include "core/texture/felt_identification.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>

#include <Eigen/Dense>

#include "core/base/csv.h"
#include "core/base/portable_math.h"
#include "core/signal/fft.h"

namespace fyd::texture {
namespace {

constexpr double kRate_Hz = 1000.0;
constexpr int kCountsPerTurn = 4096;
constexpr double kCount_deg = 360.0 / kCountsPerTurn;
constexpr int kForGood = 5;  // samples that an encoder must stay away from where it stood
constexpr double kCoarsestRamp_percent = 1.0;
constexpr double kLowest_Hz = 10.0;
constexpr double kHighest_Hz = 400.0;
constexpr double kHeldOutBand_Hz = 5.0;
constexpr double kShortestChirp_s = 4.0;
constexpr double kApart_deg = 10.0;
constexpr double kGoodError = 0.3;
constexpr double kUsableError = 0.6;
constexpr double kUsableSigma = 0.1;  // of the resonance
constexpr int kParts = 10;            // of a millisecond, for the motor

using Part = std::vector<SweepRow>;
using Complex = std::complex<double>;

std::vector<Part> partsOf(const std::vector<SweepRow>& sweep) {
  std::vector<Part> out;
  for (const SweepRow& row : sweep) {
    if (out.empty() || out.back().back().part != row.part) out.emplace_back();
    out.back().push_back(row);
  }
  return out;
}

/// The motor whose ramp it is; −1: none.
int rampedMotor(const Part& part) {
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

bool isChirp(const Part& part) {
  int turns = 0;
  for (std::size_t n = 1; n < part.size(); ++n) {
    if (part[n].duty_percent[0] != part[n].duty_percent[1]) return false;
    if (part[n].duty_percent[0] * part[n - 1].duty_percent[0] < 0.0) ++turns;
  }
  return turns > 100;
}

struct Ramp {
  double breakaway_percent = 0.0;  // signed
};

Result<Ramp> readRamp(const Part& part, std::size_t motor, const FeltPlant& base) {
  const auto moved = [&](std::size_t n) {
    const int away = part[n].encoder_counts[motor] - part.front().encoder_counts[motor];
    return (away + kCountsPerTurn + kCountsPerTurn / 2) % kCountsPerTurn - kCountsPerTurn / 2;
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
  for (std::size_t n = 0; n + kForGood <= part.size(); ++n) {
    bool for_good = true;
    for (std::size_t k = n; k < n + kForGood; ++k) for_good = for_good && moved(k) != 0;
    if (!for_good) continue;
    const double duty = part[n].duty_percent[motor];
    if (duty == 0.0) return fail("part {}: motor {} moves before it has a duty", part.front().part, motor + 1);
    // A motor that creeps fights the position loop up to the count's edge, half a count away on average; one that
    // jumps has broken away just now.
    const std::size_t later = std::min(n + 20, part.size() - 1);
    const bool creeps = std::abs(moved(later)) < 3;
    const double fought = creeps ? 0.5 * kCount_deg * base.position_gain_percent_per_deg : 0.0;
    return Ramp{std::copysign(std::max(std::abs(duty) - fought, 0.0), duty)};
  }
  return fail("part {}: motor {} did not turn up to a duty of {} %; expected a ramp until it turns", part.front().part,
              motor + 1, largest);
}

/// Acceleration of the rollers' mean in g, one value a millisecond.
std::vector<double> rollers(const Part& part, const FeltPlant& plant, double sliding_share) {
  std::vector<double> out;
  std::array<double, kFeltMotors> speed{};
  std::array<double, kFeltMotors> angle{};
  const double dt = 1.0 / kRate_Hz / kParts;
  const double push = plant.free_speed_deg_s / (plant.time_constant_ms * 1e-3) * dt;
  for (const SweepRow& row : part) {
    double before = 0.0;
    double after = 0.0;
    for (std::size_t i = 0; i < kFeltMotors; ++i) {
      before += speed[i];
      const double breakaway = plant.breakaway_percent[i] / 100.0;
      for (int k = 0; k < kParts; ++k) {
        const double duty =
            std::clamp(row.duty_percent[i] - plant.position_gain_percent_per_deg * angle[i], -100.0, 100.0) / 100.0;
        const double friction = push * breakaway * (speed[i] == 0.0 ? 1.0 : sliding_share);
        const double free = speed[i] + push * (duty - speed[i] / plant.free_speed_deg_s);
        speed[i] = std::copysign(std::max(std::abs(free) - friction, 0.0), free);
        angle[i] += dt * speed[i];
      }
      after += speed[i];
    }
    out.push_back((after - before) / kFeltMotors * kRate_Hz / plant.degreesPerG());
  }
  return out;
}

struct Bins {
  std::vector<double> frequency_Hz;
  std::vector<Complex> in;
  std::vector<Complex> out;
};

std::vector<Complex> spectrumOf(const std::vector<double>& x) {
  signal::RealFft fft(static_cast<int>(x.size()));
  std::copy(x.begin(), x.end(), fft.time().begin());
  fft.forward();
  return {fft.bins().begin(), fft.bins().end()};
}

struct Model {
  double resonance_Hz = 70.0;
  double damping = 0.3;
  double delay_ms = 0.0;
  double gain = 1.0;
};

Complex follow(const Model& m, double frequency_Hz) {
  const double r = frequency_Hz / m.resonance_Hz;
  const Complex across(0.0, 2.0 * m.damping * r);
  return (1.0 + across) / (1.0 - r * r + across) *
         math::polar(1.0, -2.0 * std::numbers::pi * frequency_Hz * m.delay_ms * 1e-3);
}

bool heldOut(double frequency_Hz) { return static_cast<int>(frequency_Hz / kHeldOutBand_Hz) % 2 == 1; }

/// Least squares of the bins that are not held out; sets the gain. @return the sum left
double fit(const Bins& bins, Model& m) {
  double in = 0.0;
  double both = 0.0;
  double out = 0.0;
  for (std::size_t k = 0; k < bins.in.size(); ++k) {
    if (heldOut(bins.frequency_Hz[k])) continue;
    const Complex x = follow(m, bins.frequency_Hz[k]) * bins.in[k];
    in += std::norm(x);
    both += (std::conj(x) * bins.out[k]).real();
    out += std::norm(bins.out[k]);
  }
  m.gain = in > 0.0 ? both / in : 0.0;
  return in > 0.0 ? out - both * both / in : out;
}

double heldOutError(const Bins& bins, const Model& m) {
  double error = 0.0;
  double out = 0.0;
  for (std::size_t k = 0; k < bins.in.size(); ++k) {
    if (!heldOut(bins.frequency_Hz[k])) continue;
    error += std::norm(bins.out[k] - m.gain * follow(m, bins.frequency_Hz[k]) * bins.in[k]);
    out += std::norm(bins.out[k]);
  }
  return out > 0.0 ? std::sqrt(error / out) : std::numeric_limits<double>::infinity();
}

Model best(const Bins& bins) {
  Model found;
  double least = std::numeric_limits<double>::infinity();
  const auto attempt = [&](Model m) {
    const double left = fit(bins, m);
    if (!(left < least)) return false;
    least = left;
    found = m;
    return true;
  };
  for (double f = 15.0; f < 300.0; f *= 1.08) {
    for (const double z : {0.08, 0.15, 0.25, 0.4, 0.65, 1.0}) {
      for (const double d : {-1.0, 0.0, 1.0, 2.0, 4.0}) attempt({f, z, d, 1.0});
    }
  }
  double step = 0.04;
  while (step > 1e-5) {
    bool better = false;
    for (const double sign : {-1.0, 1.0}) {
      better = attempt({found.resonance_Hz * (1.0 + sign * step), found.damping, found.delay_ms, 1.0}) || better;
      better = attempt({found.resonance_Hz, found.damping * (1.0 + sign * step), found.delay_ms, 1.0}) || better;
      better = attempt({found.resonance_Hz, found.damping, found.delay_ms + sign * step * 10.0, 1.0}) || better;
    }
    if (!better) step *= 0.5;
  }
  return found;
}

/// Standard deviations of resonance and damping from the fit's Jacobian.
std::array<double, 2> sigmas(const Bins& bins, const Model& m) {
  const std::array<std::function<Model(double)>, 4> moved = {
      [&](double e) {
        return Model{m.resonance_Hz * (1.0 + e), m.damping, m.delay_ms, m.gain};
      },
      [&](double e) {
        return Model{m.resonance_Hz, m.damping * (1.0 + e), m.delay_ms, m.gain};
      },
      [&](double e) {
        return Model{m.resonance_Hz, m.damping, m.delay_ms + e, m.gain};
      },
      [&](double e) {
        return Model{m.resonance_Hz, m.damping, m.delay_ms, m.gain * (1.0 + e)};
      }};
  constexpr double kStep = 1e-4;
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  double left = 0.0;
  double used = 0.0;
  for (std::size_t k = 0; k < bins.in.size(); ++k) {
    const double f = bins.frequency_Hz[k];
    if (heldOut(f)) continue;
    const auto value = [&](const Model& x) { return x.gain * follow(x, f) * bins.in[k]; };
    const Complex here = value(m);
    std::array<Complex, 4> slope;
    for (std::size_t i = 0; i < 4; ++i) slope[i] = (value(moved[i](kStep)) - here) / kStep;
    for (Eigen::Index i = 0; i < 4; ++i) {
      for (Eigen::Index j = 0; j < 4; ++j) {
        normal(i, j) += (std::conj(slope[static_cast<std::size_t>(i)]) * slope[static_cast<std::size_t>(j)]).real();
      }
    }
    left += std::norm(bins.out[k] - here);
    used += 2.0;
  }
  const Eigen::Matrix4d covariance = normal.inverse() * left / std::max(used - 4.0, 1.0);
  return {m.resonance_Hz * std::sqrt(covariance(0, 0)), m.damping * std::sqrt(covariance(1, 1))};
}

Bins binsOf(const std::vector<double>& in, const std::vector<double>& measured) {
  const auto x = spectrumOf(in);
  const auto y = spectrumOf(measured);
  Bins out;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double f = static_cast<double>(k) * kRate_Hz / static_cast<double>(in.size());
    if (f < kLowest_Hz || f > kHighest_Hz) continue;
    out.frequency_Hz.push_back(f);
    out.in.push_back(x[k]);
    out.out.push_back(y[k]);
  }
  return out;
}

Result<std::vector<double>> measuredOf(const Part& chirp) {
  std::vector<double> out;
  double mean = 0.0;
  for (const SweepRow& row : chirp) {
    if (!std::isfinite(row.acceleration_g)) {
      return fail(
          "part {}: no acceleration_g at {} s; the chirp needs an accelerometer on the cloth: encoders, load "
          "cell and currents cannot see it",
          row.part, row.t_s);
    }
    out.push_back(row.acceleration_g);
    mean += row.acceleration_g;
  }
  mean /= static_cast<double>(out.size());
  for (double& v : out) v -= mean;  // gravity
  return out;
}

struct Chirp {
  const Part* part = nullptr;
  std::vector<double> measured;
};

struct Fitted {
  double sliding_share = 1.0;
  double left = 0.0;
  std::vector<Bins> bins;
  std::vector<Model> models;
};

Fitted fitChirps(const std::vector<Chirp>& chirps, const FeltPlant& plant, double sliding_share) {
  Fitted out;
  out.sliding_share = sliding_share;
  for (const Chirp& chirp : chirps) {
    out.bins.push_back(binsOf(rollers(*chirp.part, plant, sliding_share), chirp.measured));
    Model model = best(out.bins.back());
    out.left += fit(out.bins.back(), model);
    out.models.push_back(model);
  }
  return out;
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
    for (std::size_t way = 0; way < 2; ++way) {
      if (ramps[i][way].empty()) {
        return fail("no ramp of motor {} with {} duty; expected each motor both ways", i + 1,
                    way == 0 ? std::string_view("+") : std::string_view("-"));
      }
    }
    const double forward = mean(ramps[i][0]);
    const double backward = mean(ramps[i][1]);
    double spread = 0.0;
    double count = 0.0;
    for (std::size_t way = 0; way < 2; ++way) {
      for (const double v : ramps[i][way]) {
        spread += math::square(v - (way == 0 ? forward : backward));
        count += 1.0;
      }
    }
    const double random = count > 2.0 ? spread / (count - 2.0) / count : 0.0;
    const double edge = kCount_deg * base.position_gain_percent_per_deg / std::sqrt(12.0) / std::sqrt(2.0);
    out[i] = {.percent = 0.5 * (forward + backward),
              .sigma_percent = std::sqrt(random + edge * edge),
              .asymmetry_percent = 0.5 * std::abs(forward - backward)};
  }
  return out;
}

}  // namespace

Result<std::vector<SweepRow>> parseSweep(std::string_view text, std::string_view source_name) {
  const auto table = parseCsv(text, source_name,
                              {"t_s", "part", "stretch_deg", "duty1_percent", "duty2_percent", "encoder1_counts",
                               "encoder2_counts", "acceleration_g"},
                              EmptyField::nan);
  if (!table) return tl::unexpected(table.error());
  std::vector<SweepRow> out;
  for (std::size_t n = 0; n < table->rows(); ++n) {
    const auto at = [&](std::size_t column) { return table->values[column][n]; };
    for (std::size_t column = 0; column < 7; ++column) {
      const bool encoder = column == 5 || column == 6;
      const double most = encoder ? kCountsPerTurn - 1 : column == 0 ? 1e9 : column == 1 ? 1e6 : 180.0;
      const double least = encoder || column == 1 ? 0.0 : -most;
      const bool whole = encoder || column == 1;
      if (!(at(column) >= least && at(column) <= most) || (whole && at(column) != std::floor(at(column)))) {
        return fail("{}:{}: {} = {}: expected a number from {} to {}", source_name, table->lines[n],
                    table->columns[column], at(column), least, most);
      }
    }
    if (n > 0) {
      const double step_ms = 1e3 * (at(0) - out.back().t_s);
      if (static_cast<int>(at(1)) == out.back().part && !(std::abs(step_ms - 1e3 / kRate_Hz) < 0.2)) {
        return fail("{}:{}: {} ms after the row before; expected a row each millisecond", source_name, table->lines[n],
                    step_ms);
      }
    }
    out.push_back({.t_s = at(0),
                   .part = static_cast<int>(at(1)),
                   .stretch_deg = at(2),
                   .duty_percent = {at(3), at(4)},
                   .encoder_counts = {static_cast<int>(at(5)), static_cast<int>(at(6))},
                   .acceleration_g = at(7)});
  }
  return out;
}

Result<FeltIdentification> identifyPlant(const std::vector<SweepRow>& sweep, const FeltPlant& base) {
  FeltIdentification out;
  out.plant = base;
  std::array<std::array<std::vector<double>, 2>, kFeltMotors> ramps;
  std::vector<Chirp> chirps;
  const std::vector<Part> parts = partsOf(sweep);
  for (const Part& part : parts) {
    if (isChirp(part)) {
      const double length_s = static_cast<double>(part.size()) / kRate_Hz;
      if (length_s < kShortestChirp_s) {
        return fail("part {}: a chirp of {} s; expected {} s and more", part.front().part, length_s, kShortestChirp_s);
      }
      auto measured = measuredOf(part);
      if (!measured) return tl::unexpected(measured.error());
      chirps.push_back({&part, std::move(*measured)});
      continue;
    }
    const int motor = rampedMotor(part);
    if (motor < 0) {
      return fail("part {}: neither a ramp of one motor nor a chirp of both with the same duty", part.front().part);
    }
    const auto ramp = readRamp(part, static_cast<std::size_t>(motor), base);
    if (!ramp) return tl::unexpected(ramp.error());
    ramps[static_cast<std::size_t>(motor)][ramp->breakaway_percent > 0.0 ? 0 : 1].push_back(
        std::abs(ramp->breakaway_percent));
  }
  const auto found = breakaways(ramps, base);
  if (!found) return tl::unexpected(found.error());
  out.breakaway = *found;
  for (std::size_t i = 0; i < kFeltMotors; ++i) out.plant.breakaway_percent[i] = out.breakaway[i].percent;

  double lowest_deg = std::numeric_limits<double>::infinity();
  double highest_deg = -lowest_deg;
  for (const Chirp& chirp : chirps) {
    lowest_deg = std::min(lowest_deg, chirp.part->front().stretch_deg);
    highest_deg = std::max(highest_deg, chirp.part->front().stretch_deg);
  }
  if (chirps.size() < 2 || highest_deg - lowest_deg < kApart_deg) {
    return fail("{} chirps, stretches {} ° apart; expected two or more chirps, {} ° apart", chirps.size(),
                chirps.empty() ? 0.0 : highest_deg - lowest_deg, kApart_deg);
  }
  Fitted fitted;
  for (const double share : {1.0, 0.9, 0.8, 0.7, 0.6}) {
    Fitted attempt = fitChirps(chirps, out.plant, share);
    if (fitted.models.empty() || attempt.left < fitted.left) fitted = std::move(attempt);
  }
  out.sliding_share = fitted.sliding_share;

  double stretch = 0.0;
  double resonance = 0.0;
  double damping = 0.0;
  double gain = 0.0;
  for (std::size_t i = 0; i < chirps.size(); ++i) {
    const Model& m = fitted.models[i];
    const auto [sigma_Hz, sigma_damping] = sigmas(fitted.bins[i], m);
    const FoundCloth cloth{.part = chirps[i].part->front().part,
                           .stretch_deg = chirps[i].part->front().stretch_deg,
                           .resonance_Hz = m.resonance_Hz,
                           .sigma_Hz = sigma_Hz,
                           .damping = m.damping,
                           .sigma_damping = sigma_damping,
                           .gain = m.gain,
                           .delay_ms = m.delay_ms,
                           .held_out_error = heldOutError(fitted.bins[i], m)};
    if (!(cloth.held_out_error <= kUsableError)) {
      return fail("part {}: the model leaves {:.0f} % of the acceleration held out; expected at most {:.0f} %",
                  cloth.part, 100.0 * cloth.held_out_error, 100.0 * kUsableError);
    }
    if (!(cloth.sigma_Hz <= kUsableSigma * cloth.resonance_Hz)) {
      return fail("part {}: resonance {:.1f} ± {:.1f} Hz: not determined; expected ± {:.0f} % or better", cloth.part,
                  cloth.resonance_Hz, cloth.sigma_Hz, 100.0 * kUsableSigma);
    }
    out.cloths.push_back(cloth);
    out.held_out_error = std::max(out.held_out_error, cloth.held_out_error);
    const auto count = static_cast<double>(chirps.size());
    stretch += cloth.stretch_deg / count;
    resonance += cloth.resonance_Hz / count;
    damping += cloth.damping / count;
    gain += cloth.gain / count;
  }
  double across = 0.0;
  double along = 0.0;
  for (const FoundCloth& cloth : out.cloths) {
    along += math::square(cloth.stretch_deg - stretch);
    across += (cloth.stretch_deg - stretch) * (cloth.resonance_Hz - resonance);
    out.sigma_resonance_Hz = std::max(out.sigma_resonance_Hz, cloth.sigma_Hz);
  }
  out.plant.stretch_deg = stretch;
  out.plant.resonance_Hz = resonance;
  out.plant.damping = damping;
  out.plant.cloth_gain = gain;
  out.plant.resonance_Hz_per_deg = across / along;
  out.plant.identified = true;
  out.verdict = out.held_out_error <= kGoodError ? "good" : "usable";
  return out;
}

}  // namespace fyd::texture
