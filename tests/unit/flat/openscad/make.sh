#!/bin/sh
# Exports each shape of this directory with OpenSCAD 2021.01, NAME.scad to NAME.svg. The tests compare host/flat with them.
# Text is set in the fonts of Debian 12's fonts-liberation2 and fonts-dejavu-core.
# ./make.sh exports all shapes, ./make.sh NAME.scad... only the named ones.
set -eu
cd "$(dirname "$0")"
[ "$#" -gt 0 ] || set -- *.scad
for file in "$@"; do
  openscad -q -o "${file%.scad}.svg" "$file"
done
