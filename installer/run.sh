#!/usr/bin/env bash
# Installs what is missing, builds, and opens the console on its simulated touchpad and robot.
# With no display, or with --headless, it runs a session without a window instead. Other arguments go to the console.
set -euo pipefail
source "$(dirname "$0")/common.sh"

headless=
arguments=()
for argument in "$@"; do
  if [ "$argument" = --headless ]; then headless="--headless"; else arguments+=("$argument"); fi
done

install_packages run
build release -DFYD_BUILD_TESTS=OFF -DFYD_BUILD_BENCHMARKS=OFF -DFYD_BUILD_PYTHON=OFF
[ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || headless="No display"
[ -n "$headless" ] || exec "$root/build/release/bin/fyd-console" "${arguments[@]}"
say "$headless: running a session of 10 s without a window, on the simulated touchpad and robot"
[ ${#arguments[@]} -eq 0 ] || say "Not used, they are for the window: ${arguments[*]}"
exec "$root/build/release/bin/fyd" station --simulate --duration 10
