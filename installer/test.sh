#!/usr/bin/env bash
# Installs what is missing, builds everything and runs all tests.
# $1: another preset than release (debug, asan, tsan, fuzz, coverage, branches).
set -euo pipefail
source "$(dirname "$0")/common.sh"

preset=${1:-release}
groups=(run package test)
case $preset in tsan | fuzz) groups+=(clang) ;; coverage | branches) groups+=(coverage) ;; esac
install_packages "${groups[@]}"
build "$preset" -DFYD_BUILD_PYTHON=AUTO -DFYD_BUILD_TESTS=ON -DFYD_WARNINGS_AS_ERRORS="${CI:+ON}"
say "Running the tests"
cd "$root"
ctest --preset "$preset" --no-tests=error
