#!/bin/sh
# assembled_test.sh: checks that the stored words are those assembled from the sources. Exit code 77 without assembler.
set -eu
cd "$(dirname "$0")"
command -v m68k-linux-gnu-as >/dev/null || exit 77
./assemble.sh programs.s | diff programs.inc -
command -v m68k-linux-gnu-gcc >/dev/null || exit 0
m68k-linux-gnu-gcc -dumpversion | grep -q '^12' || exit 0
./assemble.sh compiled/methods.c -O0 | diff compiled/plain.inc -
./assemble.sh compiled/methods.c -O1 | diff compiled/optimised.inc -
