#!/bin/sh
# Makes the meshes here again with OpenSCAD 2021.01: NAME.off from each NAME.scad, NAME.svg from those that are flat, and
# corner.* in the other formats; heights_*.png, and heights_NAME.off from each and from heights_numbers.dat.
set -eu
cd "$(dirname "$0")"
for model in *.scad; do
  case "$model" in
    heights.scad) ;;
    shadow.scad | cut.scad) openscad -o "${model%.scad}.svg" "$model" ;;
    *) openscad -o "${model%.scad}.off" "$model" ;;
  esac
done
for format in stl amf 3mf; do
  openscad -o "corner.$format" corner.scad
done
rm -f corner_zipped.amf
python3 -m zipfile -c corner_zipped.amf corner.amf
python3 make_pictures.py
for file in heights_*.dat heights_*.png; do
  openscad -o "${file%.*}.off" -D "file=\"$file\"" heights.scad
done
