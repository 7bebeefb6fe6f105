#!/bin/sh
# traces/benchmark/renew.sh CSGSIM: compiles the Programs of the benchmark again and writes its pictures and expected
# values. Then give suite.toml a new version: tests/benchmark/benchmark_test.py version prints its line of versions.csv.
set -eu
csgsim=$(realpath "$1")
here=$(realpath "$(dirname "$0")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$csgsim" bench-suite --compile -o "$work/suite" --machines pixel-planes-4 >/dev/null
rm -f "$here"/programs/* "$here"/pictures/*
cp "$work"/suite/programs/*.txt "$here/programs/"
for program in "$here"/programs/*.txt; do
  name=$(basename "$program" .txt)
  # A Program that names no machine runs on Pixel-planes 4, with a warning.
  "$csgsim" run "$program" -o "$here/pictures/$name.png" --quiet 2>/dev/null
done
# Ends with 1 where values differ from the old ones.
"$csgsim" bench-suite --results "$work/results.csv" || true
# Columns 3 to 5 describe the run: simulator, level, seconds.
cut -d, -f1,2,6- "$work/results.csv" > "$here/expected.csv"
