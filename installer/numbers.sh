#!/bin/bash
# Measures every subject of `fyd bench` and puts the result into the manual and the README:
#   installer/numbers.sh [--quick]
# The page says how long it took. Run it on a machine that does nothing else; on a busy one the figures are of the others
# too. What is measured must be built of the present revision without changes, so that the page names what it is of: commit,
# then build. --quick only shows that it works: such a page fails the test manual_numbers.
set -euo pipefail
CDPATH= cd -- "$(dirname -- "$0")/.."
programs=${FYD_PROGRAMS:-build/release/bin}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if [[ " $* " != *" --quick "* ]] && revision=$(git rev-parse --short=12 HEAD 2>/dev/null); then
  built=$(grep -o '"[^"]*"' "$programs/../app/bench/revision.inc" || true)
  if [[ "$built" != "\"$revision\"" ]]; then
    echo "numbers.sh: $programs/fyd-bench is built of ${built:-nothing}; expected \"$revision\": commit and build it again" >&2
    exit 1
  fi
fi
"$programs/fyd" bench --all --out "$folder" "$@"
/usr/bin/python3 resources/manual/numbers/take.py "$folder"
