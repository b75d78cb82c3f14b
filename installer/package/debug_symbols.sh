#!/bin/sh
# debug_symbols.sh ROOT FILE…: the debug symbols of programs and libraries, where gdb looks for them below ROOT/lib/debug.
# Not CPack's own packages of symbols: their lists of checksums name the folder of the build.
set -e
root=$1
shift
for file; do
  id=$(readelf -n "$file" | sed -n 's/.*Build ID: //p')
  if [ -z "$id" ]; then
    echo "$file: has no build id" >&2
    exit 1
  fi
  folder=$root/lib/debug/.build-id/$(echo "$id" | cut -c1-2)
  mkdir -p "$folder"
  symbols=$folder/$(echo "$id" | cut -c3-).debug
  objcopy --only-keep-debug --compress-debug-sections "$file" "$symbols"
  chmod 644 "$symbols"
done
