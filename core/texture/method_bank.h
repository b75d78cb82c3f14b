// Every method at every frame, made at once, so that switching needs no memory: one bank plays while another fades in.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/signal/high_pass.h"
#include "core/texture/method.h"
#include "core/texture/texture_parameters.h"

namespace fyd::texture {

/// What decides which signal is made; a change of it means a crossfade.
struct ChainChoice {
  MethodChoice method = MethodChoice::dft321;
  FilterChoice filter = FilterChoice::standard;
  double corner_Hz = 78.0;
  FrameChoice frame = FrameChoice::of_32;
  HopChoice hop = HopChoice::half;

  friend bool operator==(const ChainChoice&, const ChainChoice&) = default;
};

/// High-pass and method, one after the other.
class MethodBank {
 public:
  explicit MethodBank(double sample_rate_Hz);

  /// Starts in silence with another choice; allocation-free.
  void select(const ChainChoice& choice);
  void reset();

  /// @param acceleration_g finite
  /// @param resumed  first sample after a gap: the high-pass starts as if it had always stood there
  [[nodiscard]] double step(const Vec3& acceleration_g, bool resumed);
  /// One sample of a gap: silence into the method.
  [[nodiscard]] double stepGap();

  [[nodiscard]] const Vec3& filtered_g() const { return filtered_g_; }
  [[nodiscard]] int delaySamples() const { return method_->delaySamples(); }

 private:
  double sample_rate_Hz_;
  std::array<std::unique_ptr<Method>, kMethodNames.size()> simple_;
  std::array<std::unique_ptr<Method>, kFrameNames.size()> thesis_;
  std::array<std::array<std::unique_ptr<Method>, kHopNames.size()>, kFrameNames.size()> framed_;
  Method* method_ = nullptr;
  bool filtering_ = true;
  signal::HighPass3 filter_;
  Vec3 filtered_g_;
};

}  // namespace fyd::texture
