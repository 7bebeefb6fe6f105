#!/bin/sh
# measure.sh CSGSIM COUNTER WORDS...: prints a counter of a run of csgsim with these words. figures.txt lists the
# counters. Exit code 77 if the counting program is not installed.
set -eu
csgsim=$(realpath "$1")
counter=$2
shift 2
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Runs csgsim under a tool of valgrind: the tool's options, up to "--", precede the words.
under() {
  command -v valgrind >/dev/null || {
    echo "valgrind is not installed; ./setup.sh test installs it" >&2
    exit 77
  }
  valgrind "$@" >"$work/out" 2>"$work/log" || {
    tail -n 5 "$work/log" >&2
    # A library may use instructions that valgrind does not support, even before main().
    grep -q "Unrecognised instruction\|unhandled instruction" "$work/log" && exit 77
    exit 1
  }
}

case "$counter" in
  libraries) ldd "$csgsim" | grep -c '=>' ;;
  relocations)
    LD_DEBUG=statistics LD_DEBUG_OUTPUT="$work/ld" "$csgsim" "$@" >"$work/out"
    sed -n 's/.*final number of relocations: *//p' "$work"/ld.* | head -n 1
    ;;
  instructions)
    under --tool=callgrind --callgrind-out-file="$work/calls" "$csgsim" "$@"
    sed -n 's/^summary: *\|^totals: *//p' "$work/calls" | head -n 1
    ;;
  heap)
    under --tool=massif --massif-out-file="$work/heap" "$csgsim" "$@"
    sed -n 's/^mem_heap_B=//p' "$work/heap" | sort -n | tail -n 1
    ;;
  work-*) "$(dirname "$csgsim")/csgsim_bench" "$@" | sed -n "s/^${counter#work-} //p" ;;
  *)
    echo "unknown counter $counter" >&2
    exit 1
    ;;
esac
