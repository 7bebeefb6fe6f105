#!/bin/sh
# bare_debian.sh SUITE: runs both commands of README in a Debian of that suite (bookworm, trixie) and builds the packages
# there; installs these in another, minimal one, and uses csgsim there like a new user: draws an example, reads the
# manual, completes a word. Needs root, git and debootstrap. Uses the mirror configured for apt. Ends with 0 and
# `installed and works`, or at the first step that fails.
set -eu
cd "$(dirname "$0")/../.."
suite=$1
work=$(mktemp -d)
. tests/install/chroot.sh
trap cleaned EXIT
trap 'exit 1' INT TERM
root=$work/user
begun=$(date +%s)

step "a bare Debian, $suite"
bare "$suite" "$work/build"
cp -a "$work/build" "$root"
echo "$(inside "$root" dpkg-query -W | wc -l) packages, Debian $(cat "$root/etc/debian_version")"

sources "$work/build/csgsim"
commit=$(git log -1 --format=%h --abbrev=12)

# build COMMAND: runs ./setup.sh COMMAND; prints its warnings, the last lines of a failure, and the time.
build() {
  step "./setup.sh $1, from source"
  since=$(date +%s)
  inside "$work/build" sh -c "cd /csgsim && CSGSIM_COMMIT=$commit ./setup.sh $1" >"$work/build.log" 2>&1 || {
    tail -n 60 "$work/build.log" >&2
    exit 1
  }
  grep -E 'warning:' "$work/build.log" | sort | uniq -c || true
  echo "$((($(date +%s) - since) / 60)) minutes"
}

build demo
inside "$work/build" sh -c 'g++ --version | head -n 1; cmake --version | head -n 1; ls -l /csgsim/build/demo'
build test
grep -E '^[0-9]+% tests passed' "$work/build.log"
build package
inside "$work/build" sh -c 'ls -l /csgsim/build/*.deb'
set -- "$work"/build/csgsim/build/csgsim_*.deb "$work"/build/csgsim/build/python3-csgsim_*.deb

step "apt install ./csgsim*.deb ./python3-csgsim*.deb"
cp "$@" "$root/root/"
inside "$root" sh -c 'cd /root && apt-get update -q >/dev/null && apt-get install -qy --no-install-recommends ./*.deb' >"$root/apt.log" 2>&1 || {
  tail -n 20 "$root/apt.log" >&2
  exit 1
}
inside "$root" dpkg-query -W -f='${Package} ${Version}, ${Installed-Size} kB\n  depends: ${Depends}\n  recommends: ${Recommends}\n' csgsim
echo "$(inside "$root" dpkg-query -W | wc -l) packages now"
inside "$root" csgsim --version

step "csgsim render of an installed example"
inside "$root" sh -c 'cd /root && csgsim render /usr/share/csgsim/examples/models/carburettor.csg --view-all -o carburettor.png --stats carburettor.json'
inside "$root" sh -c 'cd /root && csgsim render /usr/share/csgsim/examples/models/carburettor.csg --view-all -o cycle.png --level cycle -q && cmp carburettor.png cycle.png'
echo "both levels drew identical pictures"

step "a picture of another format, text, a machine from its file"
inside "$root" sh -c "cd /root && echo 'text(\"csgsim\");' >text.csg && csgsim render text.csg -o text.exr --view-all --machine /usr/share/csgsim/machines/scan-line.toml -q && ls -l text.exr"

step "the module for Python draws the same"
inside "$root" sh -c "cd /root && csgsim render /usr/share/csgsim/examples/models/carburettor.csg --view-all -o program.png -q"
inside "$root" python3 -c 'import csgsim, pathlib; drawing = csgsim.render("/usr/share/csgsim/examples/models/carburettor.csg", view_all=True)
assert drawing.png() == pathlib.Path("/root/program.png").read_bytes(); print(drawing)'

step "man csgsim, man csgsim-render; completion of bash"
inside "$root" apt-get install -qy --no-install-recommends man-db bash-completion >/dev/null 2>&1
inside "$root" sh -c 'set -e; for page in csgsim csgsim-render; do man "$page" >"$page.txt"; head -n 6 "$page.txt"; done; grep -q -- "--camera NUMBERS" csgsim-render.txt'
# shellcheck disable=SC2016
inside "$root" bash -c 'source /usr/share/bash-completion/bash_completion
  _completion_loader csgsim
  complete -p csgsim
  for line in "csgsim ren" "csgsim render --strat" "csgsim render --machine scan"; do
    read -ra COMP_WORDS <<<"$line"
    COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
    _csgsim
    echo "$line<TAB>: ${COMPREPLY[*]}"
    [[ ${#COMPREPLY[@]} -eq 1 ]] || exit 1
  done'

step "and away again"
inside "$root" apt-get purge -qy csgsim python3-csgsim >/dev/null 2>&1
left=$(inside "$root" find / -xdev -name '*csgsim*' -not -path '/root/*' -not -path '/var/*' -not -path '/csgsim*')
[ -z "$left" ] || {
  echo "left behind: $left" >&2
  exit 1
}
echo "nothing is left"
printf '\ninstalled and works\n'
