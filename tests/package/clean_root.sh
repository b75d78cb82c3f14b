#!/usr/bin/env bash
# clean_root.sh FOLDER: tries the packages of FOLDER in a new Debian 12: installs an older version, upgrades, runs a session
# and the window, removes, and compares every file with those before. Needs root and the network, and minutes: it is in no
# run of ctest.
set -euo pipefail

[ $# -eq 1 ] || { echo "clean_root.sh: expected the folder of the packages" >&2; exit 2; }
packages=$(CDPATH= cd -- "$1" && pwd)
[ "$(id -u)" -eq 0 ] || { echo "clean_root.sh: needs root, to make a root folder of its own" >&2; exit 1; }
older=0.0.9
page=$(dirname "$0")/../../resources/manual/installing.md

scratch=$(mktemp -d)
trap 'rm -rf --one-file-system "$scratch"' EXIT
root=$scratch/root
say() { printf '== %s (%d s)\n' "$*" "$SECONDS"; }

say "A new Debian 12"
mmdebstrap --quiet --variant=apt --dpkgopt=force-unsafe-io bookworm "$root"
mkdir -p "$root/packages/new" "$root/packages/old"
cp "$packages"/*.deb "$root/packages/new/"
# What the page says, word for word.
grep -m1 '^sudo apt install ' "$page" >"$root/packages/install"
grep -m1 '^sudo apt-get purge ' "$page" >"$root/packages/purge"

# The same under the older version, each with a file that the newer one lacks.
for new in "$root"/packages/new/*.deb; do
  version=$(dpkg-deb -f "$new" Version)
  name=$(dpkg-deb -f "$new" Package)
  dpkg-deb -R "$new" "$scratch/unpacked"
  sed -i "s/${version//./\\.}/$older-1/g" "$scratch/unpacked/DEBIAN/control"
  [ ! -f "$scratch/unpacked/DEBIAN/shlibs" ] || sed -i "s/${version//./\\.}/$older-1/g" "$scratch/unpacked/DEBIAN/shlibs"
  echo "gone with the upgrade" >"$scratch/unpacked/usr/share/doc/$name/only-in-$older"
  (cd "$scratch/unpacked" && find . -path ./DEBIAN -prune -o -type f -printf '%P\0' | xargs -0 md5sum >DEBIAN/md5sums)
  dpkg-deb -Znone --root-owner-group -b "$scratch/unpacked" "$root/packages/old/" >/dev/null
  rm -rf "$scratch/unpacked"
done

cat >"$root/inside.sh" <<'INSIDE'
set -euo pipefail
older=$1
version=$(dpkg-deb -f "$(ls /packages/new/fyd_*.deb)" Version)
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
names=$(for each in /packages/new/*.deb; do dpkg-deb -f "$each" Package; done)
say() { printf '== %s (%d s)\n' "$*" "$SECONDS"; }
quietly() { "$@" >/tmp/said 2>&1 || { cat /tmp/said >&2; return 1; }; }
expect() { [ "$1" = "$2" ] || { echo "$3: $1, expected $2" >&2; exit 1; }; }
# Every file and link with its contents, but for logs, and for what apt, dpkg and ldconfig themselves remember.
everything() {
  find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /run -o -path /tmp -o -path /packages -o -path /var/log \
    -o -path /var/lib/apt -o -path /var/lib/dpkg -o -path /var/cache/apt -o -path /var/cache/debconf -o -path /var/cache/ldconfig \) -prune \
    -o \( -type f -exec sha256sum {} + -o -type l -printf 'link to %l  %p\n' -o -type d -printf 'folder  %p\n' \) | sort -k2
}

say "What the packages need"
quietly apt-get update
needs=$(for each in /packages/new/*.deb; do dpkg-deb -f "$each" Depends; done | tr ',' '\n' | sed 's/^ *//; /^$/d' |
  grep -vE "^($(echo $names | tr ' ' '|')) " | sort -u | paste -sd,)
quietly apt-get satisfy -y --no-install-recommends "$needs"
quietly apt-get install -y --no-install-recommends udev mount  # the rules are read, below
useradd --create-home person
everything >/tmp/before

say "Installing $older"
quietly apt-get install -y --no-install-recommends /packages/old/*.deb
for name in $names; do
  expect "$(dpkg-query -W -f='${Version}' "$name")" "$older-1" "version of $name"
  [ -e "/usr/share/doc/$name/only-in-$older" ]
done

say "Upgrading to $version"
quietly apt-get install -y --no-install-recommends /packages/new/*.deb
for name in $names; do
  expect "$(dpkg-query -W -f='${Status} ${Version}' "$name")" "install ok installed $version" "state of $name"
  [ ! -e "/usr/share/doc/$name/only-in-$older" ] || { echo "the upgrade left only-in-$older of $name" >&2; exit 1; }
done
expect "$(dpkg --verify $names)" "" "files that differ from the packages"

say "Running, as a user"
cat >/tmp/session.sh <<'SESSION'
set -euo pipefail
cd
fyd --version
fyd-console --version
fyd station --simulate --duration 3 --record session.h5 --json >session.json 2>session.log
fyd session replay session.h5 | head -3
fyd station --simulate --robot scene:echography --duration 2 --json >scene.json 2>scene.log
QT_QPA_PLATFORM=offscreen fyd-console --simulate --dump-geometry >geometry.json
grep -q '"width"' geometry.json
case " $* " in *" python3-fyd "*) python3 -c "import fyd; print(fyd.open('session.h5'))" ;; esac
SESSION
su person -c "bash /tmp/session.sh $(echo $names)"
expect "$(ldconfig -p | grep -c libfyd.so.0)" 1 "libfyd.so.0 known to the loader"

say "udev reads the rules"
mount -t sysfs sysfs /sys
udevadm test /sys/class/net/lo >/tmp/udev 2>&1
expect "$(grep -o '[^ ]*/rules\.d/70-fyd-touchpad\.rules.*' /tmp/udev)" /usr/lib/udev/rules.d/70-fyd-touchpad.rules "what udev says of the rules"
umount /sys

say "Removing"
quietly apt-get remove -y $names
everything >/tmp/removed
quietly dpkg --purge $names  # apt has forgotten those of which nothing is left
everything >/tmp/purged
expect "$(dpkg-query -W -f='${Package} ' $names 2>/dev/null || true)" "" "packages that dpkg still knows"
for after in removed purged; do
  diff /tmp/before /tmp/$after | grep '^[<>]' >/tmp/left || true
  if grep -vE ' /home/person(/|$)' /tmp/left; then
    echo "these files differ from those before, and are not the user's" >&2
    exit 1
  fi
done
say "As the page says: its first line installs, its last one removes"
sudo() { "$@"; }
printf 'APT::Install-Recommends "false";\nAPT::Get::Assume-Yes "true";\n' >/tmp/apt.conf
export APT_CONFIG=/tmp/apt.conf
installed() { dpkg-query -W -f='${db:Status-Status} ${Package}\n' $names 2>/dev/null | sed -n 's/^installed //p' | sort | paste -sd' '; }
everything >/tmp/before_page
(cd /packages/new && quietly . /packages/install)
expect "$(installed || true)" "fyd fyd-console libfyd0" "packages that the page's first line installs"
quietly . /packages/purge
expect "$(installed || true)" "" "packages that the page's last line left"
everything >/tmp/after_page
diff /tmp/before_page /tmp/after_page >&2 || { echo "these files differ from those before the page's lines" >&2; exit 1; }

say "Nothing is left but what the user made: $(grep -c '^>' /tmp/left) files and folders"
sed 's/.*  /  /' /tmp/left | sort
INSIDE
env -u TMPDIR unshare --mount --pid --fork --root="$root" --mount-proc=/proc /bin/bash /inside.sh "$older"
