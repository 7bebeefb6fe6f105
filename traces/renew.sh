#!/bin/sh
# traces/renew.sh CSGSIM [FOLDER]: compiles the Programs of this folder anew and writes their golden figures, here or into FOLDER.
set -eu
csgsim=$(realpath "$1")
out=$(realpath "${2:-$(dirname "$0")}")
cd "$(dirname "$0")/.."

# renew NAME OPTIONS...
renew() {
  name=$1
  shift
  "$csgsim" compile "tests/models/$name.csg" -o "$out/$name.csgt" "$@" >/dev/null
  "$csgsim" run "$out/$name.csgt" --stats "$out/$name.json" -o "$out/$name.png" >/dev/null
  # How long it took is no golden figure.
  sed -i 's/"wall_seconds": .*/"wall_seconds": 0/' "$out/$name.json"
}

renew thesis_fig_2_3 --camera 42,-38,41,10,5.5,2
renew carburettor --camera 220,-255,135,2,0,5 --projection perspective
renew terrain_vehicle --camera 560,-590,420,-5,0,68 --projection perspective
renew old_example002 --camera 65,-95,60,0,0,-2 --size 200x150
