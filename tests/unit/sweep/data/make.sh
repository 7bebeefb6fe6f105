#!/bin/sh
# What OpenSCAD 2021.01 makes of each shape: NAME.csg, its own reading of it, and NAME.off, its surface.
set -eu
cd "$(dirname "$0")"
for name in $(sed -n 's/^if (name == "\([a-z_]*\)").*/\1/p' shapes.scad); do
  for kind in csg off; do
    [ "$kind" = off ] && [ "$name" = l_none ] && continue  # OpenSCAD writes no file of nothing
    openscad -q -D "name=\"$name\"" -o "$name.$kind" shapes.scad
  done
done
