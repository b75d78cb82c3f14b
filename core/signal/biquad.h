// One second-order section: y(n) = b0·x(n) + b1·x(n−1) + b2·x(n−2) − a1·y(n−1) − a2·y(n−2), a0 = 1.
// Stability: may change
#pragma once

namespace fyd::signal {

struct BiquadCoefficients {
  double b0 = 1.0;
  double b1 = 0.0;
  double b2 = 0.0;
  double a1 = 0.0;
  double a2 = 0.0;
};

/// Direct form I, evaluated strictly from left to right as the equation above is written: with b = (g, −2g, g) the
/// forward part of a constant input is then exactly zero, and after the end of a signal the state becomes exactly zero
/// too, because outputs below 1e-30 are flushed (denormals would cost hundreds of cycles each).
template <class Real = double>
class Biquad {
 public:
  Biquad() = default;
  explicit Biquad(const BiquadCoefficients& c) { setCoefficients(c); }

  /// Keeps the state.
  void setCoefficients(const BiquadCoefficients& c) {
    b0_ = static_cast<Real>(c.b0);
    b1_ = static_cast<Real>(c.b1);
    b2_ = static_cast<Real>(c.b2);
    a1_ = static_cast<Real>(c.a1);
    a2_ = static_cast<Real>(c.a2);
  }

  [[nodiscard]] Real step(Real x) {
    Real y = b0_ * x + b1_ * x1_ + b2_ * x2_ - a1_ * y1_ - a2_ * y2_;
    if (y < kTiny && y > -kTiny) y = Real(0);
    x2_ = x1_;
    x1_ = x;
    y2_ = y1_;
    y1_ = y;
    return y;
  }

  void reset() { x1_ = x2_ = y1_ = y2_ = Real(0); }
  /// Steady state of a high-pass with the constant input `x`: its output is zero.
  void settleAt(Real x) {
    x1_ = x2_ = x;
    y1_ = y2_ = Real(0);
  }

  /// Without the coefficients.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(x1_, x2_, y1_, y2_);
  }

 private:
  static constexpr Real kTiny = Real(1e-30);

  Real b0_ = Real(1), b1_ = Real(0), b2_ = Real(0), a1_ = Real(0), a2_ = Real(0);
  Real x1_ = Real(0), x2_ = Real(0), y1_ = Real(0), y2_ = Real(0);
};

}  // namespace fyd::signal
