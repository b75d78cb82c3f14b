// A stored surface rendered from the finger's speed and force, when there is no robot [thesis §7.3].
//
// The surface is a sum of noise bands. Band k has its centre at f_k = v / wavelength_mm (a pattern that passes faster
// under a faster finger) or at a fixed frequency_Hz (a resonance), a quality factor Q_k, and
//
//   rms_k(v, F) = rms_g · quiet(v) · (v / v_ref)^speed_exponent · (F / F_ref)^force_exponent
//
// with quiet(v) = 0 up to 5 mm/s, then rising smoothly to 1 at 10 mm/s (thesis: nothing below 5 mm/s; its
// later cut at 60 mm/s is not repeated: above 2·v_ref the amplitude stays and only the pitch goes on rising).
// A band that has moved above 0.45 of the sample rate is silent, fading out from 0.4.
// Stability: may change
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/api.h"
#include "core/base/state.h"
#include "core/signal/resonator.h"
#include "core/texture/surface_model.h"

namespace fyd::texture {

inline constexpr double kQuietBelow_mm_s = 5.0;

/// Allocation-free after construction; deterministic from its seed.
class FYD_API VirtualTexture {
 public:
  /// @param model as parseSurface gives it @param sample_rate_Hz of the steps, more than 0
  VirtualTexture(const SurfaceModel& model, double sample_rate_Hz, std::uint64_t seed = 1);

  /// The largest speed and force there are: more counts as these.
  static constexpr double kFastest_mm_s = 1000.0, kHardest_N = 20.0;

  /// The next sample of the texture signal, in g. Speed and force that are not finite or negative count as 0;
  /// both glide over 5 ms, so that a camera's steps are not felt.
  [[nodiscard]] double step(double speed_mm_s, double force_N);
  void reset();

  [[nodiscard]] const SurfaceModel& model() const { return model_; }

  /// Without the model.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(random_, contents(bands_), speed_mm_s_, force_N_, gain_, within(until_retune_, kRetuneEvery - 1));
  }

 private:
  static constexpr int kRetuneEvery = 8;  // samples: tuning is expensive, and nothing changes that fast

  struct Band {
    SurfaceBand surface;
    signal::Resonator resonator;
    double level = 0.0;  // turns unit noise into the band's RMS

    template <class Archive>
    void serialize(Archive& archive) {
      archive(resonator, level);
    }
  };

  double white();
  void retune();

  SurfaceModel model_;
  double sample_rate_Hz_;
  std::uint64_t seed_;
  std::uint64_t random_ = 0;
  std::vector<Band> bands_;
  double speed_mm_s_ = 0.0;
  double force_N_ = 0.0;
  double gain_ = 0.0;
  int until_retune_ = 0;
};

}  // namespace fyd::texture
