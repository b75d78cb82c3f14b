#include "core/recording/writer/step_follower.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>

#include "core/recording/format/step_compare.h"

namespace fyd::recording {

StepFollower::StepFollower(const pipeline::Parameters& step, const pipeline::LocalModel& local, double pre_trigger_s)
    : pre_trigger_s_(pre_trigger_s), shadow_(step, local) {}

void StepFollower::push(const StepView& step) noexcept {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): only what is used is written
  std::array<std::byte, kLargestPackedStep> packed;
  const std::size_t bytes = packStep(step, packed);
  if (ring_.write_available() < bytes) {
    lost_.fetch_add(1, std::memory_order_relaxed);
    return;
  }
  (void)ring_.push(packed.data(), bytes);
}

Instant StepFollower::oldest() const { return newest_ - fromSeconds(pre_trigger_s_); }

StepFollower::Start StepFollower::start() const {
  const auto from = steps_.start();
  if (!from) return {.when = Clock::now(), .state = shadow_.saveState(), .parameters = shadow_.parameters()};
  return {.when = from->when, .state = from->snapshot->state, .parameters = from->snapshot->parameters};
}

void StepFollower::take() {
  while (ring_.read_available() >= packedHeadSize()) {
    ring_.pop(packed_.data(), packedHeadSize());
    const std::size_t bytes = packedSize(packed_);
    ring_.pop(packed_.data() + packedHeadSize(), bytes - packedHeadSize());  // both come from one push
    const std::span<const std::byte> step(packed_.data(), bytes);
    unpackStep(step, record_);
    follow();
    ++taken_;
    newest_ = record_.inputs.now;
    steps_.add(step, newest_);
  }
  const std::size_t most_chunks = std::max(kLeastChunks, 3 * static_cast<std::size_t>(pre_trigger_s_) + 2);
  lost_.fetch_add(steps_.trim(oldest(), most_chunks), std::memory_order_relaxed);
}

// The second pipeline takes the same step. Its state before a chunk's first row goes into the history.
void StepFollower::follow() {
  const std::uint64_t number = record_.telemetry.step;
  if (seen_a_step_ && number != last_step_ + 1) follows_ = false;  // a step was lost: see the manual
  seen_a_step_ = true;
  last_step_ = number;
  if (steps_.chunkIsDue()) {
    steps_.beginChunk({.state = follows_ ? shadow_.saveState() : std::string{}, .parameters = shadow_.parameters()});
  }
  if (!follows_) return;
  const pipeline::Outputs& outputs = shadow_.step(record_.inputs);
  if (sameStep(record_.telemetry, record_.motors, outputs.telemetry, outputs.motors)) return;
  if (differences_++ == 0) {
    const auto difference = compareSteps(record_.telemetry, record_.motors, outputs.telemetry, outputs.motors);
    spdlog::error("Recording: step {} came out otherwise a second time ({} by {:g}); recordings cannot be replayed",
                  last_step_, difference->field, difference->absolute);
  }
}

}  // namespace fyd::recording
