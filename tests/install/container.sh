#!/bin/sh
# container.sh [--check]: carries out the Containerfile in chroots instead of a container engine, and uses the result as
# its user does. Needs root, git and debootstrap. With --check, only checks that it can: that every instruction is known
# and every file that is copied exists. Ends with 0 and `built and works`, or at the first step that fails.
set -eu
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
. tests/install/chroot.sh
trap cleaned EXIT
trap 'exit 1' INT TERM

# The instructions, one per line, without comments.
sed -e '/^ *#/d' -e :join -e '/\\$/{N;s/\\\n */ /;b join' -e '}' -e '/^$/d' Containerfile >"$work/instructions"

# The suite of a line FROM debian:SUITE-slim [AS NAME].
suite_of() {
  case "$1" in
    debian:*-slim) echo "$1" | sed 's/debian:\(.*\)-slim/\1/' ;;
    *) fail "the image $1 is not debian:SUITE-slim" ;;
  esac
}

check() {
  stages=""
  while read -r word first second third; do
    case "$word $first" in
      "FROM "*)
        suite_of "$first" >/dev/null
        stages="$stages $third "
        ;;
      "COPY --from="*)
        case "$stages" in
          *" ${first#--from=} "*) ;;
          *) fail "COPY from ${first#--from=}, which is no earlier stage" ;;
        esac
        ;;
      "COPY "*)
        # shellcheck disable=SC2086
        for source in $(echo "$first $second $third" | sed 's/ *$//; s/ [^ ]*$//'); do
          [ "$source" = . ] || git ls-files --error-unmatch "$source" >/dev/null || fail "COPY of $source, which git does not have"
        done
        ;;
      "RUN "* | "WORKDIR "* | "USER "* | "ARG "*=* | "ENTRYPOINT "* | "CMD "*) ;;
      *) fail "unknown instruction: $word $first" ;;
    esac
  done <"$work/instructions"
}

# copy DESTINATION SOURCE...: COPY of files of the repository into the current stage.
copy() {
  to=$stage/$folder/$1
  shift
  mkdir -p "$to"
  for source in "$@"; do
    if [ "$source" = . ]; then sources "$to"; else cp "$source" "$to/"; fi
  done
}

carry_out() {
  while read -r word line <&3; do
    step "$word $line"
    case "$word" in
      FROM)
        # shellcheck disable=SC2086
        set -- $line
        stage=$work/${3:-final}
        folder=/
        user=root
        settings=""
        bare "$(suite_of "$1")" "$stage"
        ;;
      ARG) settings="$settings $line" ;;
      WORKDIR)
        folder=$line
        mkdir -p "$stage$folder"
        ;;
      USER) user=$line ;;
      COPY)
        # shellcheck disable=SC2086
        set -- $line
        case "$1" in
          --from=*) cp "$work/${1#--from=}/$2" "$stage/$3" ;;
          *)
            to=$(echo "$line" | sed 's/.* //')
            # shellcheck disable=SC2046
            copy "$to" $(echo "$line" | sed 's/ [^ ]*$//')
            ;;
        esac
        ;;
      RUN)
        # shellcheck disable=SC2086
        inside "$stage" --user "$user" env $settings sh -c "cd $folder && $line" >"$work/run.log" 2>&1 || {
          tail -n 40 "$work/run.log" >&2
          exit 1
        }
        ;;
      ENTRYPOINT) program=$(echo "$line" | tr -d '[]",') ;;
      CMD) ;;
    esac
  done 3<"$work/instructions"
}

# csgsim ARGUMENTS...: the container's program, as its user and in its folder.
# shellcheck disable=SC2016
csgsim() { inside "$stage" --user "$user" sh -c 'cd "$0" && exec "$@"' "$folder" "$program" "$@"; }

check
if [ "${1:-}" = --check ]; then
  echo "all instructions are known"
  exit 0
fi
carry_out
[ "$user" != root ] || fail "the container's user is root"
chmod 777 "$stage$folder" # the folder that the user mounts there

step "csgsim --version"
csgsim --version
step "csgsim render"
csgsim render /usr/share/csgsim/examples/models/carburettor.csg --view-all -o picture.png
echo 'text("csgsim");' >"$stage$folder/text.scad.csg"
csgsim render text.scad.csg --view-all -q -o text.exr
csgsim convert /usr/share/csgsim/examples/models/carburettor.csg -o carburettor.stl
ls -ln "$stage$folder"
[ "$(stat -c %u "$stage$folder/picture.png")" -ne 0 ] || fail "the picture belongs to root"
step "what the image holds"
inside "$stage" sh -c '! command -v g++ && ! ls /csgsim' 2>/dev/null || fail "the image holds a compiler or sources"
echo "$(inside "$stage" dpkg-query -W | wc -l) packages, $(du -sm --exclude=proc "$stage" | cut -f 1) MB"
printf '\nbuilt and works\n'
