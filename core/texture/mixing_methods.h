// The methods that work sample by sample.
// Stability: may change
#pragma once

#include <array>

#include "core/base/api.h"
#include "core/texture/method.h"
#include "core/texture/spectral_equaliser.h"

namespace fyd::texture {

/// The z axis alone (normal to the surface). No delay; ignores the other two.
class SingleAxis final : public Method {
 public:
  [[nodiscard]] double step(const Vec3& filtered_g) override { return filtered_g.z; }
  void reset() override {}
  [[nodiscard]] int delaySamples() const override { return 0; }

  template <class Archive>
  void serialize(Archive&) {}
};

/// Sum of components [thesis §5.3]: x + y + z. No delay; axes in antiphase cancel.
class SumOfComponents final : public Method {
 public:
  [[nodiscard]] double step(const Vec3& filtered_g) override { return filtered_g.x + filtered_g.y + filtered_g.z; }
  void reset() override {}
  [[nodiscard]] int delaySamples() const override { return 0; }

  template <class Archive>
  void serialize(Archive&) {}
};

/// √(x² + y² + z²), less its own mean over 0.1 s (a motor cannot render a mean). No delay; frequencies come out doubled
/// and most of the energy goes with the mean.
class FYD_API Magnitude final : public Method {
 public:
  explicit Magnitude(double sample_rate_Hz);
  [[nodiscard]] double step(const Vec3& filtered_g) override;
  void reset() override { mean_ = 0.0; }
  [[nodiscard]] int delaySamples() const override { return 0; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(mean_);
  }

 private:
  double share_;
  double mean_ = 0.0;
};

/// Projection onto the axis of largest variance over the last 0.25 s (one power iteration a sample on the running
/// covariance, so the axis turns smoothly and keeps its sign). No delay; what moves across the axis is lost.
class FYD_API PrincipalAxis final : public Method {
 public:
  explicit PrincipalAxis(double sample_rate_Hz);
  [[nodiscard]] double step(const Vec3& filtered_g) override;
  void reset() override;
  [[nodiscard]] int delaySamples() const override { return 0; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(covariance_, axis_);
  }

 private:
  double share_;
  std::array<double, 6> covariance_{};  // xx, yy, zz, xy, xz, yz
  Vec3 axis_;
};

/// This project's own, without delay: a fixed unequal mix x + 0.6·y + 0.36·z, recoloured by the spectral equaliser so
/// that each band has the energy of the three axes together. Unequal weights cancel neither equal axes in antiphase nor
/// equal axes with different delays, which the equaliser could not undo; only motion with x + 0.6·y + 0.36·z = 0 at all
/// times stays silent. The equaliser needs about 50 ms of a new signal to learn its spectrum; before, the mix passes as
/// it is.
class FYD_API Recolour final : public Method {
 public:
  explicit Recolour(double sample_rate_Hz) : equaliser_(sample_rate_Hz) {}
  [[nodiscard]] double step(const Vec3& filtered_g) override;
  void reset() override { equaliser_.reset(); }
  [[nodiscard]] int delaySamples() const override { return 0; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(equaliser_);
  }

 private:
  SpectralEqualiser equaliser_;
};

}  // namespace fyd::texture
