// From time-stamped samples, in bunches, repeated or missing, to one sample per step.
//
// The stream's own grid advances by exactly one period T = 1/rate per step and stays `delay` to `delay` + T behind the
// caller's clock (one period further away from it, the grid is set anew). At the start and after a gap it is set so
// that the first sample lies in the middle of its period: a sensor at this rate then gives one sample per period in
// spite of ±T/2 of jitter. One step takes what is stamped within its period (g − T, g]:
//
//   one sample              → that sample, unchanged (its time is off by at most T/2)
//   several                 → their mean: a box filter of T, which also reduces the aliases of a faster sensor;
//                             each of a sensor's repeated readings counts (the robot's loop is faster than it)
//   none, but its two neighbours are at most `maximum_gap` apart
//                           → the straight line between them at the middle of the period (clocks that slip)
//   none otherwise          → a gap: the step says so and has no value; nothing is made up
//
// Refused and counted: what is not plausible (acceleration_sample.h), stamps before the newest one, stamps more than 1 ms in
// the future, samples whose period is already past, and what does not fit the queue of 256.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/base/api.h"
#include "core/base/state.h"
#include "core/base/time.h"
#include "core/texture/acceleration_sample.h"

namespace fyd::texture {

class FYD_API UniformStream {
 public:
  struct Step {
    bool gap = true;       ///< no value
    bool resumed = false;  ///< the first value after a gap, or ever
    Vec3 acceleration_g;   ///< zero in a gap
  };

  explicit UniformStream(double rate_Hz);

  /// Alloc-free; takes effect at the next step.
  void configure(double delay_ms, double maximum_gap_ms);

  void push(Instant now, std::span<const AccelerationSample> samples);
  [[nodiscard]] Step step(Instant now);
  /// Forgets the queue and the grid; counters stay.
  void reset();

  [[nodiscard]] std::uint64_t gaps() const { return gaps_; }
  [[nodiscard]] std::uint64_t refused() const { return refused_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(queue_, within(first_, kCapacity - 1), within(count_, kCapacity), running_, origin_, steps_, until_,
            last_call_, newest_, before_, has_newest_, has_before_, in_gap_, gaps_, refused_);
  }

 private:
  static constexpr std::size_t kCapacity = 256;

  void advanceGrid(Instant now);
  void setGrid(Instant until);
  [[nodiscard]] const AccelerationSample& front() const { return queue_[first_]; }
  void pop();
  [[nodiscard]] Step value(const Vec3& acceleration_g);

  double rate_Hz_;
  Duration period_;
  Duration delay_{};
  Duration maximum_gap_{};
  std::array<AccelerationSample, kCapacity> queue_{};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  bool running_ = false;    // the grid is set
  Instant origin_{};        // of the grid
  std::int64_t steps_ = 0;  // since the origin
  Instant until_{};         // end of the present period
  Instant last_call_{};
  AccelerationSample newest_;  // accepted
  AccelerationSample before_;  // the last one used
  bool has_newest_ = false;
  bool has_before_ = false;
  bool in_gap_ = true;
  std::uint64_t gaps_ = 0;
  std::uint64_t refused_ = 0;
};

}  // namespace fyd::texture
