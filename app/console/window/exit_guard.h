// An end that nobody asked for: when the display is gone (the X server died, the session was torn down), Qt and Xlib end
// the program by exit(), from the middle of an event. What exit() takes down is still used by the session's threads
// then, so the session is ended first, and nothing is taken down after it.
#pragma once

#include <functional>

namespace fyd::console {

inline constexpr int kDisplayLost = 3;  ///< exit code

class ExitGuard {
 public:
  /// At most one at a time. @param end stops the motors and closes the recording without touching the window
  explicit ExitGuard(std::function<void()> end);
  ~ExitGuard();  ///< the program ends in order: exit() is what it is again
  ExitGuard(const ExitGuard&) = delete;
  ExitGuard& operator=(const ExitGuard&) = delete;
};

}  // namespace fyd::console
