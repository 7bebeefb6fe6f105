#!/bin/sh
# check.sh CSGSIM COUNTER FIGURE WORDS...: is what the counter shows within a band about the figure?
set -eu
csgsim=$1
counter=$2
figure=$3
shift 3
measured=$("$(dirname "$0")/measure.sh" "$csgsim" "$counter" "$@")
case "$counter" in
  work-*) band=1.1 ;;
  *) band=1.5 ;;
esac
awk -v measured="$measured" -v figure="$figure" -v band="$band" -v what="$counter of csgsim $*" 'BEGIN {
  printf "%s: %d, %.2f of %d\n", what, measured, measured / figure, figure
  if (measured <= figure * band && measured >= figure / band) exit 0
  print "if the change is meant: tests/guard/renew.sh build/release/csgsim, and tell why in the commit"
  exit 1
}'
