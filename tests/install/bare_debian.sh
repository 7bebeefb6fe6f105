#!/bin/sh
# bare_debian.sh PACKAGE...: creates a minimal Debian 12, installs the packages in it, and uses csgsim there like a new
# user: draws an example, reads the manual, completes a word. Needs root and debootstrap. Uses the mirror configured for
# apt. Ends with 0 and `installed and works`, or at the first step that fails.
set -eu

mirror=$(apt-get indextargets --format '$(RELEASE) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' |
  awk '$1 == "bookworm" && $2 == "main" { print $3; exit }')
[ -n "$mirror" ] || {
  echo "bare_debian.sh: apt has no source for bookworm, so no mirror is known" >&2
  exit 1
}

root=$(mktemp -d)
cleaned() {
  for mounted in "$root/proc" "$root/sys"; do
    if mountpoint -q "$mounted"; then umount "$mounted"; fi
  done
  rm -rf --one-file-system "$root"
}
trap cleaned EXIT
trap 'exit 1' INT TERM

inside() {
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive chroot "$root" "$@"
}
step() { printf '\n== %s\n' "$*"; }

step "a bare Debian 12"
debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" 2>&1 || {
  tail -n 20 "$root.log" >&2
  exit 1
}
rm -f "$root.log"
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc" # programs use it to find their own folder
echo "$(inside dpkg-query -W | wc -l) packages, Debian $(cat "$root/etc/debian_version")"

step "apt install ./csgsim*.deb ./python3-csgsim*.deb"
cp "$@" "$root/root/"
inside sh -c 'cd /root && apt-get update -q >/dev/null && apt-get install -qy --no-install-recommends ./*.deb' >"$root/apt.log" 2>&1 || {
  tail -n 20 "$root/apt.log" >&2
  exit 1
}
inside dpkg-query -W -f='${Package} ${Version}, ${Installed-Size} kB\n  depends: ${Depends}\n  recommends: ${Recommends}\n' csgsim
echo "$(inside dpkg-query -W | wc -l) packages now"
inside csgsim --version

step "csgsim render of an installed example"
inside sh -c 'cd /root && csgsim render /usr/share/csgsim/examples/models/carburettor.csg --view-all -o carburettor.png --stats carburettor.json'
inside sh -c 'cd /root && csgsim render /usr/share/csgsim/examples/models/carburettor.csg --view-all -o cycle.png --level cycle -q && cmp carburettor.png cycle.png'
echo "both levels drew identical pictures"

step "a picture of another format, text, a machine from its file"
inside sh -c "cd /root && echo 'text(\"csgsim\");' >text.csg && csgsim render text.csg -o text.exr --view-all --machine /usr/share/csgsim/machines/scan-line.toml -q && ls -l text.exr"

step "the module for Python draws the same"
inside sh -c "cd /root && csgsim render /usr/share/csgsim/examples/models/carburettor.csg --view-all -o program.png -q"
inside python3 -c 'import csgsim, pathlib; drawing = csgsim.render("/usr/share/csgsim/examples/models/carburettor.csg", view_all=True)
assert drawing.png() == pathlib.Path("/root/program.png").read_bytes(); print(drawing)'

step "man csgsim, man csgsim-render; completion of bash"
inside apt-get install -qy --no-install-recommends man-db bash-completion >/dev/null 2>&1
inside sh -c 'set -e; for page in csgsim csgsim-render; do man "$page" >"$page.txt"; head -n 6 "$page.txt"; done; grep -q -- "--camera NUMBERS" csgsim-render.txt'
# shellcheck disable=SC2016
inside bash -c 'source /usr/share/bash-completion/bash_completion
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
inside apt-get purge -qy csgsim python3-csgsim >/dev/null 2>&1
left=$(inside find / -xdev -name '*csgsim*' -not -path '/root/*' -not -path '/var/*' -not -path '/csgsim*')
[ -z "$left" ] || {
  echo "left behind: $left" >&2
  exit 1
}
echo "nothing is left"
printf '\ninstalled and works\n'
