// A surface as a sum of noise bands, its text form (resources/textures/*.toml), and a fit to a recording.
//
// TOML: name, description, reference_speed_mm_s, reference_force_N, speed_exponent, force_exponent, and [[band]] tables
// with wavelength_mm or frequency_Hz, quality and rms_g. Every key but description is required; others are refused.
// Stability: may change
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/signal/welch.h"

namespace fyd::texture {

struct SurfaceBand {
  double wavelength_mm = 0.0;  ///< > 0: the centre moves with the finger
  double frequency_Hz = 0.0;   ///< > 0: the centre stays; exactly one of the two is given
  double quality = 1.0;        ///< centre over −3 dB width
  double rms_g = 0.0;          ///< at the reference speed and force
};

struct SurfaceModel {
  std::string name;
  std::string description;
  double reference_speed_mm_s = 40.0;
  double reference_force_N = 1.0;
  double speed_exponent = 0.5;
  double force_exponent = 0.5;
  std::vector<SurfaceBand> bands;  ///< 1…kMaximumBands
};

inline constexpr std::size_t kMaximumBands = 32;

/// Reads a model from TOML text.
/// @return an error with source name and line: missing or unknown key, wrong type, value out of range
[[nodiscard]] FYD_API Result<SurfaceModel> parseSurface(std::string_view text, std::string_view source_name);

/// Text that parseSurface reads back equal, or refuses for what no model may have.
[[nodiscard]] FYD_API std::string formatSurface(const SurfaceModel& model);

struct SurfaceFit {
  SurfaceModel model;
  double spectral_match = 0.0;  ///< of the model's own spectrum with the recording's, as in spectral_match.h
};

struct FitConditions {
  static constexpr double kSlowest_mm_s = 1.0, kFastest_mm_s = 1000.0;
  static constexpr double kSlowest_Hz = 1.0, kFastest_Hz = 1e6;
  static constexpr double kLeastForce_N = 0.01, kLargestForce_N = 20.0;
  std::string name;
  double sample_rate_Hz = 1000.0;
  double speed_mm_s = 0.0;  ///< of the finger in the recording; 0: unknown, the bands then stay at fixed frequencies
  double force_N = 1.0;
};

/// Bands of a third of an octave from 20 Hz (or a tenth of a rate too low for that; below is the hand's own motion) to
/// 0.4 of the rate. Their powers come closest to the sum of the axes' Welch spectra, less each axis' mean, in the
/// Kullback-Leibler sense, by multiplicative updates [Lee 2001], which keep them positive. Bands under −50 dB
/// of the strongest are left out. One recording does not tell exponents: they stay at their defaults.
/// @return an error when the recording is shorter than 64 samples, silent, beyond kLargestAcceleration_g, or a condition
/// is out of range
[[nodiscard]] FYD_API Result<SurfaceFit> fitSurface(std::span<const double> x_g, std::span<const double> y_g,
                                                    std::span<const double> z_g, const FitConditions& conditions);

}  // namespace fyd::texture
