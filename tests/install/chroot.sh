# shellcheck shell=sh disable=SC2154
# Functions for tests in a Debian that debootstrap makes. Read by bare_debian.sh and container.sh, which run as root and
# set $work, a temporary folder.

step() { printf '\n== %s\n' "$*"; }

fail() {
  echo "$(basename "$0"): $*" >&2
  exit 1
}

# mirror SUITE: the mirror that apt is configured with; that of another release if it has none for this one.
mirror() {
  apt-get indextargets --format '$(RELEASE) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' |
    awk -v suite="$1" '
      $2 != "main" || $1 !~ /^(bookworm|trixie|forky|sid|stable|testing|unstable)$/ { next }
      $1 == suite { exact = $3 }
      any == "" { any = $3 }
      END { print exact == "" ? any : exact }'
}

# bare SUITE FOLDER: a minimal Debian of that suite.
bare() {
  found=$(mirror "$1")
  [ -n "$found" ] || fail "apt has no source of Debian, so no mirror is known"
  debootstrap --variant=minbase "$1" "$2" "$found" >"$work/debootstrap.log" 2>&1 || {
    tail -n 20 "$work/debootstrap.log" >&2
    exit 1
  }
}

# Programs read /proc to find their own folder; tests at a terminal open one in /dev/pts.
mounted() {
  mountpoint -q "$1/proc" || mount -t proc proc "$1/proc"
  mountpoint -q "$1/dev/pts" || mount -t devpts devpts "$1/dev/pts"
}

# inside FOLDER [--user USER] COMMAND...: runs a command in it with no variables of this system.
inside() {
  inside_folder=$1
  shift
  inside_user=root
  if [ "$1" = --user ]; then
    inside_user=$2
    shift 2
  fi
  mounted "$inside_folder"
  env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive chroot --userspec="$inside_user" "$inside_folder" "$@"
}

# sources FOLDER: copies the files of this repository there, as they are now.
sources() {
  mkdir -p "$1"
  git ls-files -z | tar --null --files-from=- --create --file=- | tar --extract --file=- --directory="$1" --no-same-owner
}

# Unmounts and removes $work. A mount that remains must not be removed.
cleaned() {
  for one in "$work"/*/proc "$work"/*/dev/pts; do
    if mountpoint -q "$one"; then umount "$one"; fi
  done
  rm -rf --one-file-system "$work"
}
