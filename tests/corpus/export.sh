#!/bin/sh
# Writes X.csg beside each X.scad of the corpus with OpenSCAD 2021.01: export.sh [X.scad ...], all of them if none is named.
# A .csg file names what it imports relative to itself, with the time of its last change: here always the same.
set -eu
cd "$(dirname "$0")"
openscad --version 2>&1 | grep -q '2021\.01' || { echo "export.sh: the corpus is OpenSCAD 2021.01's" >&2; exit 1; }
python3 make_data.py
TZ=UTC touch -t 202001010000 data/*
[ $# -gt 0 ] || set -- *.scad parts/*.scad
for scad in "$@"; do
  csg=$(basename "$scad" .scad).csg
  (cd "$(dirname "$scad")" && openscad -o "$csg" "$(basename "$scad")" && [ -s "$csg" ])
done
