#include "core/texture/uniform_stream.h"

namespace fyd::texture {
namespace {

constexpr Duration kFutureAllowed = std::chrono::milliseconds(1);

}  // namespace

UniformStream::UniformStream(double rate_Hz) : rate_Hz_(rate_Hz), period_(fromSeconds(1.0 / rate_Hz)) {}

void UniformStream::configure(double delay_ms, double maximum_gap_ms) {
  delay_ = fromSeconds(delay_ms * 1e-3);
  maximum_gap_ = fromSeconds(maximum_gap_ms * 1e-3);
}

void UniformStream::reset() {
  first_ = count_ = 0;
  running_ = has_newest_ = has_before_ = false;
  in_gap_ = true;
}

void UniformStream::push(Instant now, std::span<const AccelerationSample> samples) {
  // A clock that jumps backwards makes every stamp before it worthless.
  if (has_newest_ && newest_.taken > now + kFutureAllowed) reset();
  for (const AccelerationSample& sample : samples) {
    const bool ordered = !has_newest_ || sample.taken >= newest_.taken;
    const bool in_time = !running_ || sample.taken > until_;
    const bool past = sample.taken <= now + kFutureAllowed;
    if (!plausible(sample.acceleration_g) || !ordered || !in_time || !past || count_ == kCapacity) {
      ++refused_;
      continue;
    }
    newest_ = sample;
    has_newest_ = true;
    queue_[(first_ + count_) % kCapacity] = sample;
    ++count_;
  }
}

void UniformStream::advanceGrid(Instant now) {
  const Instant wanted = now - delay_;
  if (running_) {
    ++steps_;
    // From the origin, not from the last step: a period that is no whole number of nanoseconds must not drift.
    until_ = origin_ + fromSeconds(static_cast<double>(steps_) / rate_Hz_);
    const Duration off = until_ - wanted;
    if (off > period_ || off < -2 * period_ || now < last_call_) setGrid(wanted);
  } else {
    setGrid(wanted);
  }
  if (!in_gap_ || count_ == 0) return;
  const Instant middle = front().taken + period_ / 2;
  const Duration away = (middle - wanted) % period_;  // whole periods away from `middle`, and not after `wanted`
  setGrid(wanted + away - (away > Duration::zero() ? period_ : Duration::zero()));
}

void UniformStream::setGrid(Instant until) {
  running_ = true;
  origin_ = until_ = until;
  steps_ = 0;
}

void UniformStream::pop() {
  before_ = front();
  has_before_ = true;
  first_ = (first_ + 1) % kCapacity;
  --count_;
}

UniformStream::Step UniformStream::value(const Vec3& acceleration_g) {
  const bool resumed = in_gap_;
  in_gap_ = false;
  return {.gap = false, .resumed = resumed, .acceleration_g = acceleration_g};
}

UniformStream::Step UniformStream::step(Instant now) {
  advanceGrid(now);
  last_call_ = now;
  const Instant from = until_ - period_;
  const bool had_before = has_before_;
  const AccelerationSample left = before_;
  while (count_ > 0 && front().taken <= from) {  // skipped over when the grid was set anew
    pop();
    ++refused_;
  }
  Vec3 sum;
  int taken = 0;
  while (count_ > 0 && front().taken <= until_) {
    sum = sum + front().acceleration_g;
    ++taken;
    pop();
  }
  if (taken == 1) return value(sum);
  if (taken > 1) return value((1.0 / taken) * sum);

  if (had_before && !in_gap_ && count_ > 0 && left.taken < front().taken &&
      front().taken - left.taken <= maximum_gap_) {
    const double whole = toSeconds(front().taken - left.taken);
    const double part = toSeconds(until_ - period_ / 2 - left.taken) / whole;
    if (part >= 0.0 && part <= 1.0) {
      return value(left.acceleration_g + part * (front().acceleration_g - left.acceleration_g));
    }
  }
  if (!in_gap_) ++gaps_;
  in_gap_ = true;
  return {};
}

}  // namespace fyd::texture
