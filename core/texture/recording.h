// Recorded accelerations: their text form, their uniform form, and the offline rendering that programs and measurements
// share.
// Stability: may change
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/texture/acceleration_sample.h"
#include "core/texture/chain.h"
#include "core/texture/rest_removal.h"
#include "core/texture/test_signals.h"
#include "core/texture/uniform_stream.h"

namespace fyd::texture {

struct Recording {
  std::vector<AccelerationSample> samples;  ///< in order of time, from instant 0; values may be NaN
  double start_s = 0.0;                     ///< the first row's t_s
  double rate_Hz = 0.0;                     ///< 1 / median spacing, or as given when there are no different times
};

/// CSV with columns t_s, ax, ay, az, in any order among others; or exactly three columns, x y z, then `rate_Hz` is
/// needed. A first line of numbers counts as data. Accelerations may be NaN, times may not, nor go backwards,
/// nor last longer than a day or follow each other slower than ten a second: those are no seconds.
/// @param rate_Hz 0: from the times
/// @return an error with source name, line, value and what was expected
[[nodiscard]] FYD_API Result<Recording> parseRecording(std::string_view text, std::string_view source_name,
                                                       double rate_Hz);

/// @return an error for a signal of more than 10 million samples
[[nodiscard]] FYD_API Result<void> checkSamples(double count, double span_s, double rate_Hz);

/// One step per period of `rate_Hz`, from the first sample to the last (uniform_stream.h). Samples further apart than
/// one and a half periods of the recording or of `rate_Hz`, whichever is longer, are a gap.
struct UniformRecording {
  std::vector<UniformStream::Step> steps;
  std::uint64_t gaps = 0;
  std::uint64_t refused = 0;
};
/// @return an error by checkSamples, or for a rate under 1/100 of the recording's
[[nodiscard]] FYD_API Result<UniformRecording> makeUniform(const Recording& recording, double rate_Hz);

/// Rest removal (not with filter none), high-pass and method as one streaming object.
class FYD_API OfflineChain {
 public:
  OfflineChain(FilterChoice filter, double corner_Hz, double sample_rate_Hz, std::unique_ptr<Method> method);

  [[nodiscard]] double step(const UniformStream::Step& sample);
  [[nodiscard]] const Vec3& filtered_g() const { return chain_.filtered_g(); }
  [[nodiscard]] int delaySamples() const { return chain_.delaySamples(); }

 private:
  bool remove_rest_;
  RestRemoval rest_;
  std::unique_ptr<Method> method_;
  Chain chain_;
};

}  // namespace fyd::texture
