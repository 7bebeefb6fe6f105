#!/bin/sh
# Checks the timing of sync signals: video_timing_test.v.
#   video_timing_test.sh SOURCES PROGRAM
set -eu
iverilog -g2005 -Wall -s video_timing_test -o "$2" "$1/tests/rtl/video_timing_test.v" "$1/hw/rtl/video_timing.v"
said=$(vvp -n "$2")
echo "$said"
[ "$said" = equal ]
