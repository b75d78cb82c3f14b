// Takes the haptic loop's steps onto the recorder's thread, makes each a second time, and keeps the last seconds.
#pragma once

#include <atomic>
#include <vector>

#include "core/base/ring.h"
#include "core/pipeline/pipeline.h"
#include "core/recording/packed_step.h"
#include "core/recording/writer/step_history.h"

namespace fyd::recording {

class StepFollower {
 public:
  /// @param pre_trigger_s how long steps are kept
  StepFollower(const pipeline::Parameters& step, const pipeline::LocalModel& local, double pre_trigger_s);

  /// From the haptic loop: never waits nor allocates; a full ring is counted in `lost`, as is what the history drops
  /// before it was written.
  void push(const StepView& step) noexcept;
  [[nodiscard]] std::uint64_t lost() const { return lost_.load(std::memory_order_relaxed); }

  // The recorder's thread:
  /// Takes what waits in the ring, and drops what is older than the pre-trigger.
  void take();
  /// Of the pre-trigger, before the newest step.
  [[nodiscard]] Instant oldest() const;
  /// Where a recording that starts now begins: the oldest kept step, or now when there is none.
  struct Start {
    Instant when{};
    std::string state;  ///< Pipeline::saveState before that step; empty: not known
    pipeline::Parameters parameters;
  };
  [[nodiscard]] Start start() const;
  [[nodiscard]] StepHistory& history() { return steps_; }
  [[nodiscard]] std::uint64_t taken() const { return taken_; }
  /// Steps that came out otherwise the second time.
  [[nodiscard]] std::uint64_t differences() const { return differences_; }

 private:
  /// At least 2 s of steps whose every list is full, 12 s of usual ones.
  static constexpr std::size_t kRingBytes = 2000 * kLargestPackedStep;
  /// Seconds that wait for a slow disk, however short the pre-trigger is.
  static constexpr std::size_t kLeastChunks = 32;

  void follow();

  Ring<std::byte> ring_{kRingBytes};
  std::atomic<std::uint64_t> lost_{0};

  const double pre_trigger_s_;
  pipeline::Pipeline shadow_;
  bool follows_ = true;
  bool seen_a_step_ = false;
  std::uint64_t last_step_ = 0;
  std::uint64_t taken_ = 0;
  Instant newest_{};
  std::uint64_t differences_ = 0;
  StepHistory steps_;
  StepRecord record_;  // scratch
  std::vector<std::byte> packed_ = std::vector<std::byte>(kLargestPackedStep);
};

}  // namespace fyd::recording
