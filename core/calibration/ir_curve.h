// The curves a distance sensor's calibration chooses from, each fitted on a scaled basis.
//
//   thesis, scaled   d = s·P(v) + o, with P the thesis polynomial: a sensor close to the datasheet's
//   inverse          d = a/(v + b) + c
//   polynomial 2…5   d = c₀ + c₁v + …, fitted on Chebyshev polynomials of the span, then written as powers of volts
//
// Distances are exact and volts are noisy, and a millivolt is far more millimetres far away than near: points are
// weighted by 1/(σ_d² + (slope·σ_v)²), with the slope of the thesis curve, the same for all candidates.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/sensing/ir_distance.h"

namespace fyd::calibration {

enum class IrCandidate : std::uint8_t { thesis_scaled, inverse, degree2, degree3, degree4, degree5 };
/// In rising number of coefficients that are free.
inline constexpr std::array kIrCandidates = {IrCandidate::thesis_scaled, IrCandidate::inverse, IrCandidate::degree2,
                                             IrCandidate::degree3,       IrCandidate::degree4, IrCandidate::degree5};

[[nodiscard]] std::string_view toString(IrCandidate candidate);
/// Coefficients that the points decide.
[[nodiscard]] std::size_t freedomOf(IrCandidate candidate);

struct IrCurve {
  IrCandidate candidate = IrCandidate::degree2;
  sensing::IrCurveForm form = sensing::IrCurveForm::polynomial;
  std::vector<double> coefficients;     ///< as sensing::IrDistance takes them
  std::vector<double> standard_errors;  ///< of each; NaN without degrees of freedom
  double condition_number = 0.0;        ///< of the scaled design

  /// The sensor as the step reads it.
  [[nodiscard]] sensing::IrDistance sensor(int lowest_code, int highest_code) const;
};

struct IrPoints {
  std::vector<double> volts;
  std::vector<double> distance_mm;
  std::vector<double> weight;
};
/// @param noise_mV of one reading of the sensor
[[nodiscard]] IrPoints irPoints(std::span<const double> adc, std::span<const double> distance_mm, double noise_mV);
[[nodiscard]] IrPoints rowsOf(const IrPoints& points, std::span<const std::size_t> rows);

/// @return an error when the points do not decide the coefficients
[[nodiscard]] Result<IrCurve> fitIrCurve(IrCandidate candidate, const IrPoints& points);

}  // namespace fyd::calibration
