# Shared by run.sh and test.sh; sourced, not run.
root=$(CDPATH= cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '== %s\n' "$*"; }

# One line of progress that a terminal overwrites; in a log a new line, at most one in ten seconds.
progress_shown=-10
show_progress() {
  if [ -t 1 ]; then
    printf '\r%s\033[K' "$*"
  elif [ $((SECONDS - progress_shown)) -ge 10 ]; then
    printf '%s\n' "$*"
    progress_shown=$SECONDS
  fi
}
end_progress() { [ ! -t 1 ] || printf '\r\033[K'; }

# Reads what apt-get writes to its status descriptor: "pmstatus:PACKAGE:PERCENT:TEXT" and "dlstatus:…".
show_installing() {
  local kind package percent text
  while IFS=: read -r kind package percent text; do
    case $kind in
      dlstatus | pmstatus) show_progress "[ ${percent%.*} % ] $text" ;;
      pmerror) printf '%s: %s\n' "$package" "$text" ;;
    esac
  done
  end_progress
}

# Installs what of installer/packages.txt is missing. $@: the groups wanted (run, package, test).
install_packages() {
  local wanted missing=() package architecture
  wanted=$(awk -v groups=" $* " '!/^#/ && NF == 2 && index(groups, " " $1 " ") {print $2}' "$root/installer/packages.txt")
  architecture=$(dpkg --print-architecture)
  for package in $wanted; do
    # A line for each architecture that it is known of; a held package is installed, too.
    dpkg-query -W -f='${Architecture} ${db:Status-Status}\n' "$package" 2>/dev/null |
      grep -qxE "(all|$architecture) installed" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "These packages are missing and neither root nor sudo is here: ${missing[*]}" >&2; return 1; }
    as_root=(sudo)
  fi
  say "Installing ${#missing[@]} packages and what they need: ${missing[*]}"
  "${as_root[@]}" apt-get update -qq
  # APT closes its status descriptor for dpkg and the packages' scripts, so it must not be their standard output; and sudo
  # passes on none above 2, so it is opened behind sudo.
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive sh -c 'exec apt-get install -y -qq --no-install-recommends \
    -o APT::Status-Fd=3 -o Dpkg::Use-Pty=0 "$@" 3>&1 >/dev/null' sh "${missing[@]}" | show_installing
}

# Reads Ninja's lines "[ 37/392 ] Building …" and shows how far the build is and about how long it still takes; passes on
# everything else, such as warnings. What one step takes is first assumed (2.6 s of one processor, measured), then known.
show_building() {
  local line began=$SECONDS done total left assumed_steps=20
  local assumed_s=$((assumed_steps * 26 / 10 / $(nproc)))
  while IFS= read -r line; do
    if [[ $line =~ ^\[\ ([0-9]+)/([0-9]+)\ \] ]]; then
      done=${BASH_REMATCH[1]} total=${BASH_REMATCH[2]}
      left=$(((SECONDS - began + assumed_s) * (total - done) / (done + assumed_steps)))
      if [ "$left" -ge 90 ]; then
        left="about $(((left + 30) / 60)) min left"
      else
        left="about $left s left"
      fi
      show_progress "[ $done/$total ] $left"
    elif [ "$line" != "ninja: no work to do." ]; then
      end_progress
      printf '%s\n' "$line"
    fi
  done
  end_progress
}

# $1: preset, then options for CMake.
build() {
  local preset=$1
  shift
  say "Building preset $preset"
  (cd "$root" && cmake --preset "$preset" "$@" >/dev/null &&
    NINJA_STATUS='[ %f/%t ] ' cmake --build --preset "$preset" 2>&1 | show_building)
}
