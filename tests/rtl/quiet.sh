#!/bin/sh
# Icarus and Yosys accept the Verilog of hw/rtl without warnings; Verilator checks it in every build.
#   quiet.sh SOURCES [cell_chain=FOLDER] WORDS...    each word is a set of parameters, KEY=NUMBER separated by commas,
#   for
#                                                   pixel_planes or for the chain of cells in a folder of hw/rtl
set -eu
cd "$1/hw/rtl"
shift
top=pixel_planes
case $1 in
  cell_chain=*)
    top=${1%=*}
    cd "${1#*=}"
    shift
    ;;
esac
log=$(mktemp)
trap 'rm -f "$log" "$log.vvp"' EXIT
for set in "$@"; do
  icarus=""
  yosys=""
  for parameter in $(echo "$set" | tr , ' '); do
    icarus="$icarus -P$top.$parameter"
    yosys="$yosys -chparam ${parameter%=*} ${parameter#*=}"
  done
  # shellcheck disable=SC2086
  if command -v iverilog >/dev/null; then
    iverilog -g2005 -Wall -s $top -o "$log.vvp" $icarus ./*.v >>"$log" 2>&1 || echo "iverilog fails" >>"$log"
  fi
  if command -v yosys >/dev/null; then
    yosys -q -p "read_verilog *.v; hierarchy -check -top $top $yosys; proc; check -assert" >>"$log" 2>&1 || echo "yosys fails" >>"$log"
  fi
done
cat "$log"
[ ! -s "$log" ]
