#!/usr/bin/env bash
# Installs what is missing, builds everything and runs all tests.
# $1: another preset than release.
set -euo pipefail
source "$(dirname "$0")/common.sh"

preset=${1:-release}
groups=(run package test)
presets="release debug asan tsan fuzz coverage branches"
if [[ " $presets " != *" $preset "* ]]; then
  echo "test.sh: '$preset' is no preset of the tests; expected one of: $presets" >&2
  exit 2
fi
case $preset in tsan | fuzz) groups+=(clang) ;; coverage | branches) groups+=(coverage) ;; esac
install_packages "${groups[@]}"
build "$preset" -DFYD_BUILD_PYTHON=AUTO -DFYD_BUILD_TESTS=ON -DFYD_WARNINGS_AS_ERRORS="${CI:+ON}"
say "Running the tests"
cd "$root"
ctest --preset "$preset" --no-tests=error
