#!/bin/sh
# The hosts of hw/rtl feed a machine in Icarus: host_test.v.
#   host_test.sh RTL_8X8 SOURCES FOLDER LATENCY WORD_CLOCKS
set -eu
bench=$1
sources=$2
mkdir -p "$3"
cd "$3"
command -v iverilog >/dev/null || exit 77
set -- $("$bench" host 1 "$4" "$5")
for parameter in "$@"; do
  set -- "$@" "-Phost_test.$parameter"
  shift
done
iverilog -g2005 -Wall -s host_test -o host_test.vvp -I "$sources/hw/rtl" "$@" "$sources/tests/rtl/host_test.v" \
  "$sources"/hw/rtl/*.v 2>warnings
cat warnings
[ ! -s warnings ]
said=$(vvp -n host_test.vvp)
echo "$said"
[ "$(echo "$said" | tail -n 1)" = equal ]
