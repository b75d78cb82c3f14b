// An end that nobody asked for: when the display is gone (its server died), Qt says so and calls exit() from the middle of
// an event, or _exit(). exit() destroys objects that the session's threads still use. So the session is ended first, at
// Qt's words, and nothing is destroyed after it.
#pragma once

#include <functional>

namespace fyd::console {

inline constexpr int kDisplayLost = 3;  ///< exit code

/// At most one at a time.
class ExitGuard {
 public:
  /// @param end stops the motors and closes the recording without touching the window
  explicit ExitGuard(std::function<void()> end);
  ~ExitGuard();  ///< the program ends in order: exit() is what it is again
  ExitGuard(const ExitGuard&) = delete;
  ExitGuard& operator=(const ExitGuard&) = delete;
};

}  // namespace fyd::console
