// How long work tells how far it is, and is asked to end.
#pragma once

#include <functional>

#include "core/base/error.h"

namespace fyd::session {

/// Told now and then, on the thread that works, which share is done: 0 to 1, never falling; false ends the work.
/// Empty: nobody asks.
using Progress = std::function<bool(double done)>;

/// @return an error when the work shall end
[[nodiscard]] inline Result<void> tellProgress(const Progress& progress, double done) {
  if (progress && !progress(done)) return fail("cancelled before it was done");
  return {};
}

/// For a part of larger work: its 0 to 1 are the whole's `from` to `to`.
[[nodiscard]] inline Progress partOf(const Progress& whole, double from, double to) {
  if (!whole) return {};
  return [whole, from, to](double done) { return whole(from + (to - from) * done); };
}

}  // namespace fyd::session
