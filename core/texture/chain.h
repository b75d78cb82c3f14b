// High-pass and method, one after the other.
// Stability: may change
#pragma once

#include "core/base/api.h"
#include "core/signal/high_pass.h"
#include "core/texture/method.h"
#include "core/texture/texture_parameters.h"

namespace fyd::texture {

/// `select` comes first: without a method nothing else may be called.
class FYD_API Chain {
 public:
  /// Starts in silence with this filter and method, which must outlive the chain; allocation-free.
  void select(FilterChoice filter, double corner_Hz, double sample_rate_Hz, Method& method);
  void reset();

  /// @param acceleration_g finite
  /// @param resumed  first sample after a gap: the high-pass starts in its steady state at this value
  [[nodiscard]] double step(const Vec3& acceleration_g, bool resumed);
  /// One sample of a gap: the method gets zero.
  [[nodiscard]] double stepGap();

  /// Behind the high-pass, newest; zero in a gap.
  [[nodiscard]] const Vec3& filtered_g() const { return filtered_g_; }
  [[nodiscard]] int delaySamples() const { return method_->delaySamples(); }

  /// Without filter and method, which `select` chose.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(filter_, filtered_g_);
  }

 private:
  Method* method_ = nullptr;
  bool filtering_ = true;
  signal::HighPass3 filter_;
  Vec3 filtered_g_;
};

}  // namespace fyd::texture
