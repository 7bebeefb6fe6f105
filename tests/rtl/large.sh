#!/bin/sh
# Tests that take too long for CI, in a built tree: the lockstep at 64 x 64, with chains of 8 to 64 cells, and on
# machines with random parameters.
#   large.sh BUILD    for instance build/release
set -eu
build=$1
cmake --build "$build" --target rtl_64x64 rtl_64x64_squares rtl_64x64_bare rtl_random_machines

"$build"/rtl_64x64 random 3 20 latency=4
"$build"/rtl_64x64 models thesis_fig_2_3
"$build"/rtl_64x64_squares random 3 20 latency=4
"$build"/rtl_64x64_bare speed 40
for name in 8 16 64 words_of_64 words_of_13 bits; do
  cmake --build "$build" --target "rtl_chain_$name"
  "$build"/rtl_chain_$name random 200 40
done
for name in 8 16 64; do "$build"/rtl_chain_$name models thesis_fig_2_3 carburettor; done
"$(dirname "$0")"/scan_line/area.py --check
number=0
for machine in "$build"/rtl_random_[0-9]*; do
  number=$((number + 1))
  echo "$machine:"
  "$machine" random 40 40 latency=$((number * 5 % 13)) word=$((1 + number % 3))
done
