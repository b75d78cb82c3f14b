#!/usr/bin/env bash
# Builds the Debian packages into build/package/packages; fyd-console-dbg has the debug symbols.
# --check: afterwards lets lintian judge them, builds the last commit once more, in another folder and without a compiler
#          cache, and fails when a byte of a package differs.
# Times in the packages are SOURCE_DATE_EPOCH, or those of the last commit.
set -euo pipefail
source "$(dirname "$0")/common.sh"

check=
case ${1:-} in
  '') ;;
  --check) check=1 ;;
  *) echo "package.sh $1: expected nothing or --check" >&2; exit 2 ;;
esac

# $1: folder of the sources
pack() {
  say "Packing"
  rm -rf "$1/build/package/packages"
  (cd "$1/build/package" && cpack -B packages >packed.log) || { cat "$1/build/package/packed.log" >&2; return 1; }
  rm -rf "$1/build/package/packages/_CPack_Packages"
}

if [ -z "${SOURCE_DATE_EPOCH:-}" ]; then
  SOURCE_DATE_EPOCH=$(git -C "$root" log -1 --format=%ct) ||
    { echo "package.sh: no commit whose time could be taken: set SOURCE_DATE_EPOCH, in seconds since 1970" >&2; exit 1; }
fi
export SOURCE_DATE_EPOCH
if [ -n "$check" ] && [ -n "$(git -C "$root" status --porcelain)" ]; then
  echo "package.sh --check: there are changes without a commit, and the other folder gets the last commit" >&2
  exit 1
fi

install_packages run package
build package
pack "$root"
(cd "$root/build/package/packages" && ls -sh --block-size=KiB)
[ -n "$check" ] || exit 0

install_packages test
say "No error and no warning of lintian"
(cd "$root/build/package/packages" && lintian --allow-root --fail-on error,warning -- *.deb)

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
other=$scratch/another/place/of-another-length
mkdir -p "$other"
git -C "$root" archive HEAD | tar -x -C "$other"
say "The same in $other"
first=$root
root=$other CCACHE_DISABLE=1 build package
pack "$other"
if diff <(cd "$first/build/package/packages" && sha256sum -- *.deb) <(cd "$other/build/package/packages" && sha256sum -- *.deb); then
  say "The same to the byte"
else
  echo "package.sh --check: these packages differ" >&2
  exit 1
fi
