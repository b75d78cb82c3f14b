#!/bin/bash
# Measures every subject of `fyd bench` and puts the result into the manual and the README:
#   installer/numbers.sh [--quick]
# The page says how long it took. Run it on a machine that does nothing else; on a busy one the figures are of the others
# too. --quick only shows that it works: such a page fails the test manual_numbers.
set -euo pipefail
CDPATH= cd -- "$(dirname -- "$0")/.."
programs=${FYD_PROGRAMS:-build/release/bin}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$programs/fyd" bench --all --out "$folder" "$@"
/usr/bin/python3 resources/manual/numbers/take.py "$folder"
