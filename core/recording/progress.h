// How long-running work reports its progress and is cancelled.
#pragma once

#include <functional>

#include "core/base/error.h"

namespace fyd::recording {

/// Called from time to time, on the thread that works, with the share done: 0 to 1, never falling. Returning false
/// cancels the work. Empty: progress is not reported.
using Progress = std::function<bool(double done)>;

/// @return an error when the work was cancelled
[[nodiscard]] inline Result<void> tellProgress(const Progress& progress, double done) {
  if (progress && !progress(done)) return fail("cancelled before it was done");
  return {};
}

/// Progress of a part of larger work: its 0 to 1 becomes `from` to `to` of the whole.
[[nodiscard]] inline Progress partOf(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [whole, from, to](double done) { return whole(from + (to - from) * done); };
}

}  // namespace fyd::recording
