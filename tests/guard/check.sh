#!/bin/sh
# check.sh CSGSIM COUNTER FIGURE WORDS...: is what the counter shows within a band about the figure?
set -eu
csgsim=$1
counter=$2
figure=$3
shift 3
measured=$("$(dirname "$0")/measure.sh" "$csgsim" "$counter" "$@")
awk -v measured="$measured" -v figure="$figure" -v what="$counter of csgsim $*" 'BEGIN {
  printf "%s: %d, %.2f of %d\n", what, measured, measured / figure, figure
  if (measured <= figure * 1.5 && measured >= figure / 1.5) exit 0
  print "if the change is meant: tests/guard/renew.sh build/release/csgsim, and tell why in the commit"
  exit 1
}'
