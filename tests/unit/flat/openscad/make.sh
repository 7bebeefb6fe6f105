#!/bin/sh
# Has OpenSCAD 2021.01 export each shape of this folder: NAME.scad to NAME.svg, which the tests hold host/flat against.
# Text is set in the fonts of Debian 12's fonts-liberation2 and fonts-dejavu-core.
# ./make.sh does all of them, ./make.sh NAME.scad... the named ones.
set -eu
cd "$(dirname "$0")"
[ "$#" -gt 0 ] || set -- *.scad
for file in "$@"; do
  openscad -q -o "${file%.scad}.svg" "$file"
done
