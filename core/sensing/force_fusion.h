// Indentation through the force: δ = c·F, with the compliance c = 1/k of this touch learnt from the distance sensors.
//
// Force and indentation rise and fall together; only c is unknown, and c changes no faster than the motors stretch the
// cloth. So each distance reading z = s·δ + noise becomes a reading of c, z = (s·F)·c + noise, averaged over the whole
// touch, and the load cell, which has little lag and noise, gives the indentation at once. The distance sensors alone
// force a choice between noise and lag (indentation_filter.h).
//
// When distance and force contradict each other for long (a dead load cell, a hand on the cover), the force is not
// used for the rest of the touch.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/api.h"
#include "core/base/timed.h"
#include "core/sensing/indentation_filter.h"

namespace fyd::sensing {

class FYD_API ForceFusion {
 public:
  ForceFusion();

  /// A new touch: the compliance starts in the middle of the device's range (0.3 to 0.9 N/mm [thesis §4.1.4]), with a
  /// wide uncertainty.
  void restart();

  /// The newest force, N; repeated counts are ignored, NaN makes the fusion unusable until the next number.
  void takeForce(const Timed<double>& force_N);

  /// Distance readings taken at `taken`: z = h·δ, as in IndentationFilter.
  void update(double dt_s, Instant taken, std::span<const IndentationFilter::Measurement> measurements);

  /// Compares with the indentation from the distance sensors alone.
  void compare(double dt_s, double indentation_mm, double sigma_mm);

  /// A force is there, and nothing contradicts it.
  [[nodiscard]] bool usable(Instant now) const;
  [[nodiscard]] double indentation_mm() const;
  [[nodiscard]] double sigma_mm() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(compliance_, forces_, written_, last_count_, known_, contradiction_s_, contradicted_);
  }

 private:
  struct Force {
    double value_N = 0.0;
    Instant taken{};

    template <class Archive>
    void serialize(Archive& archive) {
      archive(value_N, taken);
    }
  };

  [[nodiscard]] double forceAt(Instant when) const;

  IndentationFilter compliance_;  // of c, mm/N, in place of δ
  std::array<Force, 32> forces_{};
  std::size_t written_ = 0;
  std::uint64_t last_count_ = 0;
  bool known_ = false;
  double contradiction_s_ = 0.0;
  bool contradicted_ = false;
};

}  // namespace fyd::sensing
