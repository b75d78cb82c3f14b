#include "core/texture/felt/chirp_fit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>

#include <Eigen/Dense>

#include "core/base/portable_math.h"
#include "core/signal/fft.h"

namespace fyd::texture {
namespace {

constexpr double kLowest_Hz = 10.0;
constexpr double kHighest_Hz = 400.0;
constexpr double kHeldOutBand_Hz = 5.0;
constexpr double kShortestChirp_s = 4.0;
constexpr int kParts = 10;  // of a millisecond, for the motor

using Complex = std::complex<double>;

/// Acceleration of the rollers' mean in g, one value a millisecond.
std::vector<double> rollers(const SweepPart& part, const FeltPlant& plant, double sliding_share) {
  std::vector<double> out;
  std::array<double, kFeltMotors> speed{};
  std::array<double, kFeltMotors> angle{};
  const double dt = 1.0 / kSweepRate_Hz / kParts;
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
    out.push_back((after - before) / kFeltMotors * kSweepRate_Hz / plant.degreesPerG());
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
    const double f = static_cast<double>(k) * kSweepRate_Hz / static_cast<double>(in.size());
    if (f < kLowest_Hz || f > kHighest_Hz) continue;
    out.frequency_Hz.push_back(f);
    out.in.push_back(x[k]);
    out.out.push_back(y[k]);
  }
  return out;
}

Result<std::vector<double>> measuredOf(const SweepPart& chirp) {
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

struct Fitted {
  double sliding_share = 1.0;
  double left = 0.0;
  std::vector<Bins> bins;
  std::vector<Model> models;
};

Fitted fitWith(const std::vector<const SweepPart*>& chirps, const std::vector<std::vector<double>>& measured,
               const FeltPlant& plant, double sliding_share) {
  Fitted out;
  out.sliding_share = sliding_share;
  for (std::size_t i = 0; i < chirps.size(); ++i) {
    out.bins.push_back(binsOf(rollers(*chirps[i], plant, sliding_share), measured[i]));
    Model model = best(out.bins.back());
    out.left += fit(out.bins.back(), model);
    out.models.push_back(model);
  }
  return out;
}

}  // namespace

bool isChirp(const SweepPart& part) {
  int turns = 0;
  for (std::size_t n = 1; n < part.size(); ++n) {
    if (part[n].duty_percent[0] != part[n].duty_percent[1]) return false;
    if (part[n].duty_percent[0] * part[n - 1].duty_percent[0] < 0.0) ++turns;
  }
  return turns > 100;
}

Result<ChirpFit> fitChirps(const std::vector<const SweepPart*>& chirps, const FeltPlant& plant) {
  std::vector<std::vector<double>> measured;
  for (const SweepPart* chirp : chirps) {
    const double length_s = static_cast<double>(chirp->size()) / kSweepRate_Hz;
    if (length_s < kShortestChirp_s) {
      return fail("part {}: a chirp of {} s; expected {} s and more", chirp->front().part, length_s, kShortestChirp_s);
    }
    auto read = measuredOf(*chirp);
    if (!read) return tl::unexpected(read.error());
    measured.push_back(std::move(*read));
  }
  Fitted fitted;
  for (const double share : {1.0, 0.9, 0.8, 0.7, 0.6}) {
    Fitted attempt = fitWith(chirps, measured, plant, share);
    if (fitted.models.empty() || attempt.left < fitted.left) fitted = std::move(attempt);
  }
  ChirpFit out{.sliding_share = fitted.sliding_share};
  for (std::size_t i = 0; i < chirps.size(); ++i) {
    const Model& m = fitted.models[i];
    const auto [sigma_Hz, sigma_damping] = sigmas(fitted.bins[i], m);
    out.cloths.push_back({.part = chirps[i]->front().part,
                          .stretch_deg = chirps[i]->front().stretch_deg,
                          .resonance_Hz = m.resonance_Hz,
                          .sigma_Hz = sigma_Hz,
                          .damping = m.damping,
                          .sigma_damping = sigma_damping,
                          .gain = m.gain,
                          .delay_ms = m.delay_ms,
                          .held_out_error = heldOutError(fitted.bins[i], m)});
  }
  return out;
}

}  // namespace fyd::texture
