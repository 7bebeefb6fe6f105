#!/bin/sh
# Renders part.scad with OpenSCAD for each line of cameras.txt and writes NAME.pbm: 1 where the model is visible.
# Needs openscad, xvfb-run, netpbm and python3.
set -eu
folder=$(cd "$(dirname "$0")" && pwd)
openscad -o "$folder/part.csg" "$folder/part.scad"
picture=$(mktemp --suffix=.png)
while read -r name projection camera; do
  xvfb-run -a openscad --camera="$camera" --projection="$projection" --imgsize=100,75 --colorscheme=Nature \
    -o "$picture" "$folder/part.scad" < /dev/null
  pngtopnm "$picture" | python3 -c '
import sys
kind, width, height, most, pixels = sys.stdin.buffer.read().split(maxsplit=4)
width, height = int(width), int(height)
rows = [pixels[3 * width * y:3 * width * (y + 1)] for y in range(height)]
bits = ["".join("0" if row[3 * x:3 * x + 3] == b"\xfa\xfa\xfa" else "1" for x in range(width)) for row in rows]
print("P1", width, height, *bits, sep="\n")' > "$folder/$name.pbm"
done < "$folder/cameras.txt"
rm "$picture"
