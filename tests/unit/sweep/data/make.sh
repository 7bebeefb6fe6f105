#!/bin/sh
# Writes OpenSCAD 2021.01's results for each shape: NAME.csg, the evaluated tree, and NAME.off, the surface.
set -eu
cd "$(dirname "$0")"
for name in $(sed -n 's/^if (name == "\([a-z_]*\)").*/\1/p' shapes.scad); do
  for kind in csg off; do
    [ "$kind" = off ] && [ "$name" = l_none ] && continue  # OpenSCAD writes no file for an empty result
    openscad -q -D "name=\"$name\"" -o "$name.$kind" shapes.scad
  done
done
