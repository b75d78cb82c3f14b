// A method turns three axes of vibration into one signal, sample by sample.
// Stability: stable since 0.1
#pragma once

#include "core/base/vec3.h"

namespace fyd::texture {

/// Streaming: one sample in, one sample out. After construction nothing allocates, locks or throws.
/// Inputs are finite (the caller's duty) and in g, high-passed; the output is in g.
class Method {
 public:
  virtual ~Method() = default;

  /// The signal's next sample, `delaySamples` behind `filtered_g`.
  [[nodiscard]] virtual double step(const Vec3& filtered_g) = 0;

  /// Back to silence, as if newly made.
  virtual void reset() = 0;

  /// Constant: an impulse on one axis leaves this many samples later.
  [[nodiscard]] virtual int delaySamples() const = 0;
};

/// Largest frame a short-time method accepts.
inline constexpr int kMaximumFrame = 4096;

}  // namespace fyd::texture
