#!/bin/sh
# renew.sh CSGSIM: remeasures every figure of figures.txt.
set -eu
csgsim=$(realpath "$1")
cd "$(dirname "$0")"
while IFS= read -r row; do
  case "$row" in
    '' | '#'*) echo "$row" ;;
    *)
      # shellcheck disable=SC2086
      set -- $row
      counter=$1
      shift 2
      echo "$counter $(./measure.sh "$csgsim" "$counter" "$@") $*"
      ;;
  esac
done <figures.txt >figures.new
mv figures.new figures.txt
