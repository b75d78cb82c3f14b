// From the robot's accelerations to a duty cycle: resampling, high-pass, method, PWM mapping.
//
//   samples ─▶ UniformStream ─▶ HighPass ×3 ─▶ Method ─▶ crossfade ─▶ mapping ─▶ duty of each motor
//
// Mapping: PwmChoice (texture_parameters.h).
//
// Called once per sample period (1 ms). From time-stamped bunches to the uniform stream, see uniform_stream.h;
// in one sentence: each call takes the mean of the samples stamped within its own millisecond, a lone empty
// millisecond between two near samples is interpolated between them, and anything longer is a gap, which is
// silence and counted, never invented data.
//
// Changes of method, filter, frame, hop, k_vib, full scale, limit and dead zone, and to or from the mapping felt, glide
// over `crossfade_ms`: the signal is at every instant a weighted mean of the old and the new one, so it never exceeds
// the larger of the two. A change between the mappings symmetric and thesis acts at once.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "core/base/api.h"
#include "core/base/time.h"
#include "core/base/vec3.h"
#include "core/texture/acceleration_sample.h"
#include "core/texture/felt/felt_plant.h"
#include "core/texture/texture_parameters.h"

namespace fyd::texture {

struct TextureOutput {
  double signal_g = 0.0;  ///< after high-pass and method, before PWM; finite
  /// Of each motor; ±maximum at most, and ±100 together with the position share. Equal but with mapping felt.
  std::array<double, kFeltMotors> duty_percent{};
  double wanted_g = 0.0;  ///< wanted at the finger; the signal itself with another mapping than felt
  bool limited = false;   ///< this step's duty was cut by a limit
  Vec3 filtered_g;        ///< behind the high-pass, newest
  double delay_ms = 0.0;  ///< of input delay and method together; the stream's grid adds up to one period
  bool gap = false;       ///< no acceleration for this instant
  bool position_share_known = false;
  std::uint64_t clipped = 0;          ///< steps whose duty a limit cut, since the start
  std::uint64_t gaps = 0;             ///< gaps begun, since the first sample
  std::uint64_t refused_samples = 0;  ///< not finite, too late, out of order or stamped in the future, since the start
};

class FYD_API TextureRenderer {
 public:
  /// Makes every method at every frame; from here on nothing allocates. @param parameters each within its range, as
  /// checkParameter says
  explicit TextureRenderer(const TextureParameters& parameters);
  ~TextureRenderer();
  TextureRenderer(TextureRenderer&&) noexcept;
  TextureRenderer& operator=(TextureRenderer&&) noexcept;

  /// Applies live changes, gliding. `sample_rate_Hz` is taken at construction only.
  void configure(const TextureParameters& parameters);

  /// Present stretch of the rollers, which shifts the cloth's resonance; NaN: unknown.
  void setStretch(double stretch_deg);

  /// @param new_samples    since the last call, in any number; older ones are refused and counted
  /// @param position_share_percent  duty the board's position loop uses now, signed; NaN when it does not say
  [[nodiscard]] TextureOutput step(Instant now, std::span<const AccelerationSample> new_samples,
                                   double position_share_percent);

  /// The same from a signal that needs no filter or method: a virtual texture (virtual_texture.h).
  [[nodiscard]] TextureOutput stepVirtual(double signal_g, double position_share_percent);

  /// Silence; counters stay.
  void reset();

  /// For the archives that save and restore a step (core/base/state.h). Version 1: without the mapping felt.
  static constexpr std::uint16_t kStateVersion = 2;
  template <class Archive>
  void serialize(Archive& archive);
  template <class Archive>
  void restore(Archive& archive, std::uint16_t version);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fyd::texture
