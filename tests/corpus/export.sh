#!/bin/sh
# Writes X.csg for each X.scad of the corpus with OpenSCAD 2021.01: export.sh [X.scad ...]; by default all. A .csg file
# names its imports relative to itself, with the time of their last change, which is fixed here.
set -eu
cd "$(dirname "$0")"
openscad --version 2>&1 | grep -q '2021\.01' || { echo "export.sh: the corpus needs OpenSCAD 2021.01" >&2; exit 1; }
python3 make_data.py
TZ=UTC touch -t 202001010000 data/*
[ $# -gt 0 ] || set -- *.scad parts/*.scad
for scad in "$@"; do
  csg=$(basename "$scad" .scad).csg
  (cd "$(dirname "$scad")" && openscad -o "$csg" "$(basename "$scad")" && [ -s "$csg" ])
done
