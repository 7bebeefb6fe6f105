#!/bin/sh
# assemble.sh SOURCE [OPTIONS of m68k-linux-gnu-gcc]: writes the words of an assembly or C program, placed at address
# 0x1000, and the addresses of its labels or functions, for inclusion in a C++ namespace. Needs gcc-m68k-linux-gnu for
# C, otherwise binutils-m68k-linux-gnu.
set -eu
source=$1
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
case $source in
  *.c) m68k-linux-gnu-gcc -m68000 -ffreestanding -fno-pic -fno-tree-loop-distribute-patterns "$@" -S -o "$folder/program.s" "$source" ;;
  *) cp "$source" "$folder/program.s" ;;
esac
m68k-linux-gnu-as -m68000 --register-prefix-optional -o "$folder/program.o" "$folder/program.s"
m68k-linux-gnu-ld -Ttext 0x1000 -Tbss 0x4000 -e 0x1000 -o "$folder/program" "$folder/program.o"
m68k-linux-gnu-objcopy -O binary -j .text "$folder/program" "$folder/words"
echo "// Made by tests/m68000/assemble.sh of $(basename "$source")${1:+ with $*}."
m68k-linux-gnu-nm "$folder/program" | sort | awk '$3 ~ /^[a-z]/ && $2 ~ /^[tTbB]$/ { print "inline constexpr std::uint32_t " $3 "_at = 0x" $1 ";" }'
echo "inline constexpr auto words = std::to_array<std::uint16_t>({"
od -An -v -tx1 -w24 "$folder/words" | sed 's/ \(..\) \(..\)/ 0x\1\2,/g; s/^ /    /'
echo "});"
