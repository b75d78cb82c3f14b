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

constexpr double kLowestFitted_Hz = 10.0;
constexpr double kHighestFitted_Hz = 400.0;
constexpr double kHeldOutBand_Hz = 5.0;
constexpr double kShortestChirp_s = 4.0;
constexpr int kMotorSubsteps = 10;  // integration steps of the motor model per millisecond

using Complex = std::complex<double>;

/// Simulated acceleration of the cloth at the rollers, mean of both, one value a millisecond.
std::vector<double> rollerAcceleration_g(const SweepPart& part, const FeltPlant& plant, double sliding_share) {
  std::vector<double> out;
  std::array<double, kFeltMotors> speed{};
  std::array<double, kFeltMotors> angle{};
  const double dt = 1.0 / kSweepRate_Hz / kMotorSubsteps;
  const double full_duty_step = plant.free_speed_deg_s / (plant.time_constant_ms * 1e-3) * dt;
  for (const SweepRow& row : part) {
    double speed_before = 0.0;
    double speed_after = 0.0;
    for (std::size_t i = 0; i < kFeltMotors; ++i) {
      speed_before += speed[i];
      const double breakaway = plant.breakaway_percent[i] / 100.0;
      for (int k = 0; k < kMotorSubsteps; ++k) {
        const double duty =
            std::clamp(row.duty_percent[i] - plant.position_gain_percent_per_deg * angle[i], -100.0, 100.0) / 100.0;
        const double friction = full_duty_step * breakaway * (speed[i] == 0.0 ? 1.0 : sliding_share);
        const double driven = speed[i] + full_duty_step * (duty - speed[i] / plant.free_speed_deg_s);
        speed[i] = std::copysign(std::max(std::abs(driven) - friction, 0.0), driven);
        angle[i] += dt * speed[i];
      }
      speed_after += speed[i];
    }
    out.push_back((speed_after - speed_before) / kFeltMotors * kSweepRate_Hz / plant.rollerAccelerationPerG_deg_s2());
  }
  return out;
}

/// Of the roller's (in) and the measured (out) acceleration, 10…400 Hz.
struct Spectra {
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

/// H of chirp_fit.h with the delay, without the gain.
Complex clothResponse(const Model& m, double frequency_Hz) {
  const double r = frequency_Hz / m.resonance_Hz;
  const Complex damping_term(0.0, 2.0 * m.damping * r);
  return (1.0 + damping_term) / (1.0 - r * r + damping_term) *
         math::polar(1.0, -2.0 * std::numbers::pi * frequency_Hz * m.delay_ms * 1e-3);
}

bool heldOut(double frequency_Hz) { return static_cast<int>(frequency_Hz / kHeldOutBand_Hz) % 2 == 1; }

/// Sets the gain to its least-squares value in the bands that are not held out. @return the sum of squared residuals
double fitGain(const Spectra& spectra, Model& m) {
  double in = 0.0;
  double cross = 0.0;
  double out = 0.0;
  for (std::size_t k = 0; k < spectra.in.size(); ++k) {
    if (heldOut(spectra.frequency_Hz[k])) continue;
    const Complex x = clothResponse(m, spectra.frequency_Hz[k]) * spectra.in[k];
    in += std::norm(x);
    cross += (std::conj(x) * spectra.out[k]).real();
    out += std::norm(spectra.out[k]);
  }
  m.gain = in > 0.0 ? cross / in : 0.0;
  return in > 0.0 ? out - cross * cross / in : out;
}

double heldOutError(const Spectra& spectra, const Model& m) {
  double error = 0.0;
  double out = 0.0;
  for (std::size_t k = 0; k < spectra.in.size(); ++k) {
    if (!heldOut(spectra.frequency_Hz[k])) continue;
    error += std::norm(spectra.out[k] - m.gain * clothResponse(m, spectra.frequency_Hz[k]) * spectra.in[k]);
    out += std::norm(spectra.out[k]);
  }
  return out > 0.0 ? std::sqrt(error / out) : std::numeric_limits<double>::infinity();
}

/// Grid search, then a coordinate search with shrinking steps.
Model fitModel(const Spectra& spectra) {
  Model found;
  double least = std::numeric_limits<double>::infinity();
  const auto keepIfBetter = [&](Model m) {
    const double residual = fitGain(spectra, m);
    if (!(residual < least)) return false;
    least = residual;
    found = m;
    return true;
  };
  constexpr int kResonances = 39;  // from 15 to 300 Hz
  double f = 15.0;
  for (int i = 0; i < kResonances; ++i, f *= 1.08) {
    for (const double z : {0.08, 0.15, 0.25, 0.4, 0.65, 1.0}) {
      for (const double d : {-1.0, 0.0, 1.0, 2.0, 4.0}) keepIfBetter({f, z, d, 1.0});
    }
  }
  double step = 0.04;
  while (step > 1e-5) {
    bool better = false;
    for (const double sign : {-1.0, 1.0}) {
      better = keepIfBetter({found.resonance_Hz * (1.0 + sign * step), found.damping, found.delay_ms, 1.0}) || better;
      better = keepIfBetter({found.resonance_Hz, found.damping * (1.0 + sign * step), found.delay_ms, 1.0}) || better;
      better = keepIfBetter({found.resonance_Hz, found.damping, found.delay_ms + sign * step * 10.0, 1.0}) || better;
    }
    if (!better) step *= 0.5;
  }
  return found;
}

/// Standard deviations of resonance and damping from the Jacobian of the fit.
std::array<double, 2> standardDeviations(const Spectra& spectra, const Model& m) {
  const std::array<std::function<Model(double)>, 4> perturbed = {
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
  constexpr double kPerturbation = 1e-4;
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  double residual = 0.0;
  double values = 0.0;
  for (std::size_t k = 0; k < spectra.in.size(); ++k) {
    const double f = spectra.frequency_Hz[k];
    if (heldOut(f)) continue;
    const auto value = [&](const Model& x) { return x.gain * clothResponse(x, f) * spectra.in[k]; };
    const Complex unperturbed = value(m);
    std::array<Complex, 4> slope;
    for (std::size_t i = 0; i < 4; ++i) slope[i] = (value(perturbed[i](kPerturbation)) - unperturbed) / kPerturbation;
    for (Eigen::Index i = 0; i < 4; ++i) {
      for (Eigen::Index j = 0; j < 4; ++j) {
        normal(i, j) += (std::conj(slope[static_cast<std::size_t>(i)]) * slope[static_cast<std::size_t>(j)]).real();
      }
    }
    residual += std::norm(spectra.out[k] - unperturbed);
    values += 2.0;  // real and imaginary part
  }
  const Eigen::Matrix4d covariance = normal.inverse() * residual / std::max(values - 4.0, 1.0);
  return {m.resonance_Hz * std::sqrt(covariance(0, 0)), m.damping * std::sqrt(covariance(1, 1))};
}

Spectra spectraOf(const std::vector<double>& in, const std::vector<double>& measured) {
  const auto x = spectrumOf(in);
  const auto y = spectrumOf(measured);
  Spectra out;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double f = static_cast<double>(k) * kSweepRate_Hz / static_cast<double>(in.size());
    if (f < kLowestFitted_Hz || f > kHighestFitted_Hz) continue;
    out.frequency_Hz.push_back(f);
    out.in.push_back(x[k]);
    out.out.push_back(y[k]);
  }
  return out;
}

Result<std::vector<double>> measuredAcceleration_g(const SweepPart& chirp) {
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

struct Fits {
  double sliding_share = 1.0;
  double residual = 0.0;
  std::vector<Spectra> spectra;
  std::vector<Model> models;
};

Fits fitAll(const std::vector<const SweepPart*>& chirps, const std::vector<std::vector<double>>& measured,
            const FeltPlant& plant, double sliding_share) {
  Fits out;
  out.sliding_share = sliding_share;
  for (std::size_t i = 0; i < chirps.size(); ++i) {
    out.spectra.push_back(spectraOf(rollerAcceleration_g(*chirps[i], plant, sliding_share), measured[i]));
    Model model = fitModel(out.spectra.back());
    out.residual += fitGain(out.spectra.back(), model);
    out.models.push_back(model);
  }
  return out;
}

}  // namespace

bool isChirp(const SweepPart& part) {
  int sign_changes = 0;
  for (std::size_t n = 1; n < part.size(); ++n) {
    if (part[n].duty_percent[0] != part[n].duty_percent[1]) return false;
    if (part[n].duty_percent[0] * part[n - 1].duty_percent[0] < 0.0) ++sign_changes;
  }
  return sign_changes > 100;
}

Result<ChirpFit> fitChirps(const std::vector<const SweepPart*>& chirps, const FeltPlant& plant) {
  std::vector<std::vector<double>> measured;
  for (const SweepPart* chirp : chirps) {
    const double length_s = static_cast<double>(chirp->size()) / kSweepRate_Hz;
    if (length_s < kShortestChirp_s) {
      return fail("part {}: a chirp of {} s; expected {} s and more", chirp->front().part, length_s, kShortestChirp_s);
    }
    auto read = measuredAcceleration_g(*chirp);
    if (!read) return tl::unexpected(read.error());
    measured.push_back(std::move(*read));
  }
  Fits fits;
  for (const double share : {1.0, 0.9, 0.8, 0.7, 0.6}) {
    Fits attempt = fitAll(chirps, measured, plant, share);
    if (fits.models.empty() || attempt.residual < fits.residual) fits = std::move(attempt);
  }
  ChirpFit out{.sliding_share = fits.sliding_share};
  for (std::size_t i = 0; i < chirps.size(); ++i) {
    const Model& m = fits.models[i];
    const auto [sigma_Hz, sigma_damping] = standardDeviations(fits.spectra[i], m);
    out.cloths.push_back({.part = chirps[i]->front().part,
                          .stretch_deg = chirps[i]->front().stretch_deg,
                          .resonance_Hz = m.resonance_Hz,
                          .sigma_Hz = sigma_Hz,
                          .damping = m.damping,
                          .sigma_damping = sigma_damping,
                          .gain = m.gain,
                          .delay_ms = m.delay_ms,
                          .held_out_error = heldOutError(fits.spectra[i], m)});
  }
  return out;
}

}  // namespace fyd::texture
