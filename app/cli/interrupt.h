// Ctrl+C and a polite end (SIGTERM), for the commands that run until they are told to stop.
#pragma once

namespace fyd::cli {

/// From now on SIGINT and SIGTERM are remembered instead of ending the program.
void watchForInterrupt();

/// Whether one came since `watchForInterrupt`.
[[nodiscard]] bool wasInterrupted();

}  // namespace fyd::cli
