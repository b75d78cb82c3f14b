#!/usr/bin/env bash
# Installs what is missing, builds, and opens the console on its simulated touchpad and robot.
# With no display it runs a headless session instead and says so. Arguments go to the console.
set -euo pipefail
source "$(dirname "$0")/common.sh"

install_packages run
build release -DFYD_BUILD_TESTS=OFF -DFYD_BUILD_BENCHMARKS=OFF
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  exec "$root/build/release/bin/fyd-console" "$@"
fi
say "No display: running a headless session of 10 s on the simulated touchpad and robot instead of the window"
exec "$root/build/release/bin/fyd" station --headless --simulate --duration 10
