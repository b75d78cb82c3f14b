// One infrared distance sensor: ADC code to millimetres [thesis §2.1, §4.1.2] [GP2Y0A41SK0F].
//
//   v = 3.3·code/4096
//   polynomial   d = c₀ + c₁v + … + cₙvⁿ      (mm)
//   inverse      d = c₀/(v + c₁) + c₂         (mm; triangulation: three coefficients suffice)
//
// Without a calibration the curve is the thesis polynomial. A code outside the valid span gives no distance
// (NaN) and is never clamped to the span: beyond it the polynomial turns negative or gives up to 790 mm.
// Stability: may change
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/api.h"
#include "core/base/batch.h"
#include "core/base/parameter.h"

namespace fyd::sensing {

inline constexpr double kAdcReference_V = 3.3;
inline constexpr int kAdcCodes = 4096;

enum class IrCurveForm : std::uint8_t { polynomial, inverse };
inline constexpr std::array<std::string_view, 2> kIrCurveFormNames = {"polynomial", "inverse"};

struct IrReading {
  double distance_mm = 0.0;     ///< NaN when not valid
  double slope_mm_per_V = 0.0;  ///< |dd/dv| at this code; turns the sensor's noise into millimetres
  bool valid = false;
};

class FYD_API IrDistance {
 public:
  /// The thesis polynomial on the sensor's own span, 40…300 mm.
  IrDistance() : IrDistance({}, 524, 3408) {}
  /// @param coefficients_mm c₀…cₙ for volts; empty: the thesis polynomial
  /// @param lowest_code,highest_code valid span, both included
  /// @param form the inverse form with other than three coefficients reads nothing as valid
  IrDistance(std::span<const double> coefficients_mm, int lowest_code, int highest_code,
             IrCurveForm form = IrCurveForm::polynomial);

  /// @param code a code, or a mean of codes; NaN is out of span
  [[nodiscard]] IrReading read(double code) const;

  /// The curve without the span; for drawing and calibration.
  [[nodiscard]] double distance_mm(double volts) const;

  /// c₀…cₙ.
  [[nodiscard]] std::span<const double> coefficients() const { return coefficients_.view(); }

  /// Volts that read as `distance_mm`, at the nearest end when the span does not hold it (the curve must fall).
  /// For simulation and tests.
  [[nodiscard]] double voltsAt(double distance_mm) const;

 private:
  Batch<double, kParameterListCapacity> coefficients_;
  int lowest_code_;
  int highest_code_;
  IrCurveForm form_;
};

[[nodiscard]] constexpr double voltsFromCode(double code) { return kAdcReference_V * code / kAdcCodes; }

}  // namespace fyd::sensing
