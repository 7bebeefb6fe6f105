#!/bin/sh
# Icarus and Yosys take the Verilog of hw/rtl without a warning; Verilator does so in every build.
#   quiet.sh SOURCES WORDS...    a set of parameters a word, KEY=NUMBER separated by commas
set -eu
cd "$1/hw/rtl"
shift
log=$(mktemp)
trap 'rm -f "$log" "$log.vvp"' EXIT
for set in "$@"; do
  icarus=""
  yosys=""
  for parameter in $(echo "$set" | tr , ' '); do
    icarus="$icarus -Ppixel_planes.$parameter"
    yosys="$yosys -chparam ${parameter%=*} ${parameter#*=}"
  done
  # shellcheck disable=SC2086
  if command -v iverilog >/dev/null; then
    iverilog -g2005 -Wall -s pixel_planes -o "$log.vvp" $icarus ./*.v >>"$log" 2>&1 || echo "iverilog fails" >>"$log"
  fi
  if command -v yosys >/dev/null; then
    yosys -q -p "read_verilog *.v; hierarchy -check -top pixel_planes $yosys; proc; check -assert" >>"$log" 2>&1 || echo "yosys fails" >>"$log"
  fi
done
cat "$log"
[ ! -s "$log" ]
