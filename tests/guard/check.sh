#!/bin/sh
# check.sh CSGSIM COUNTER FIGURE WORDS...: checks that a counter is within a band around the expected figure.
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
  print "if the change is intended, run tests/guard/renew.sh build/release/csgsim and give the reason in the commit"
  exit 1
}'
