#!/usr/bin/env bash
# Takes screenshots of GTKWave with a wave of each kind of machine: docs/pictures/waves/KIND.png, or in the given folder.
# Needs csgsim on the PATH, and the packages gtkwave, xvfb, imagemagick, iverilog.
set -euo pipefail
cd "$(dirname "$0")/../.."
pictures=${1:-docs/pictures/waves}
mkdir -p "$pictures"
pictures=$(realpath "$pictures")
work=$(mktemp -d)
display=:$((100 + RANDOM % 400))
Xvfb "$display" -screen 0 1920x2400x24 > "$work/xvfb.log" 2>&1 &
server=$!
trap 'kill $server 2> /dev/null; rm -rf "$work"' EXIT
sleep 2

# photograph KIND MACHINE SIZE PIXEL
photograph() {
  csgsim compile tests/models/basics_csg.csg --view-all --machine "$2" --size "$3" -o "$work/$1.csgt" > /dev/null
  csgsim wave "$work/$1.csgt" --machine "$2" --pixel "$4" --at owner -o "$work/$1.vcd" > /dev/null
  show "$1" "$pictures/$1.png"
}

# show WAVE PICTURE
show() {
  DISPLAY=$display GDK_BACKEND=x11 HOME=$work gtkwave "$work/$1.gtkw" > "$work/gtkwave.log" 2>&1 &
  local viewer=$!
  sleep 6
  DISPLAY=$display import -window root -trim +repage "$2"
  kill $viewer
  wait $viewer 2> /dev/null || true
  test "$(stat -c %s "$2")" -gt 20000 || { echo "$2 is empty" >&2; exit 1; }
}

# The first command in docs/debugging.md.
csgsim wave traces/thesis_fig_2_3.csgt --pixel 200,300 --at owner -o "$work/frame_buffer.vcd" > /dev/null
show frame_buffer "$pictures/frame_buffer.png"

photograph scan_line scan-line 256x256 128,120
photograph pixel_square pixel-square+divider.kind=host 256x256 128,120
photograph multi_processor multi-processor 128x128 64,60
photograph bit_serial_memory simdram-ddr4 64x48 32,24

# From docs/debugging.md.
csgsim wave tests/debugging/fig_2_3_fault.txt --pixel 60,48 --window i50 -o "$work/fault.vcd" > /dev/null
show fault "$pictures/fault.png"

# From docs/hardware.md.
csgsim rtl pixel-planes-4 tests/models/thesis_fig_2_3.csg --size 16x16 -o "$work/design" > /dev/null
csgsim wave tests/models/thesis_fig_2_3.csg --size 16x16 --pixel 5,5 --window i10:i14 -o "$work/design/csgsim.vcd" > /dev/null
make -s -C "$work/design" beside > /dev/null
cd "$work/design"
show design/beside "$pictures/beside.png"
