#include "app/console/window/exit_guard.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace fyd::console {
namespace {

std::function<void()> end_of_session;  // empty: no guard

void endNow() {
  const auto end = std::exchange(end_of_session, {});
  if (!end) return;
  end();
  std::fputs("fyd-console: the display is gone; motors off, recording closed\n", stderr);
  std::fflush(nullptr);
  std::_Exit(kDisplayLost);
}

}  // namespace

ExitGuard::ExitGuard(std::function<void()> end) {
  static const bool registered = std::atexit(endNow) == 0;
  if (registered) end_of_session = std::move(end);
}

ExitGuard::~ExitGuard() { end_of_session = {}; }

}  // namespace fyd::console
