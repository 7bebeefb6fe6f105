#!/bin/sh
# traces/renew.sh CSGSIM [FOLDER]: recompiles the Programs of this folder and writes their golden results, here or into
# FOLDER.
set -eu
csgsim=$(realpath "$1")
out=$(realpath "${2:-$(dirname "$0")}")
cd "$(dirname "$0")/.."

# renew NAME MODEL MACHINE OPTIONS...
renew() {
  name=$1 model=$2 machine=$3
  shift 3
  "$csgsim" compile "tests/models/$model.csg" --machine "$machine" -o "$out/$name.csgt" "$@" >/dev/null
  "$csgsim" run "$out/$name.csgt" --machine "$machine" --stats "$out/$name.json" -o "$out/$name.png" >/dev/null
  # Removes the wall time and the configuration, which depend on the run.
  sed -i -e 's/"wall_seconds": .*/"wall_seconds": 0/' -e '/^  "configuration": {$/,/^  },$/d' "$out/$name.json"
}

whole=pixel-planes-4
renew thesis_fig_2_3 thesis_fig_2_3 $whole --camera 42,-38,41,10,5.5,2
renew carburettor carburettor $whole --camera 220,-255,135,2,0,5 --projection perspective
renew terrain_vehicle terrain_vehicle $whole --camera 560,-590,420,-5,0,68 --projection perspective
renew old_example002 old_example002 $whole --camera 65,-95,60,0,0,-2 --size 200x150
renew old_example002_lines old_example002 scan-line --camera 65,-95,60,0,0,-2 --size 100x75
renew thesis_fig_2_3_squares thesis_fig_2_3 pixel-square --camera 42,-38,41,10,5.5,2 --size 150x100
renew thesis_fig_2_3_nodes thesis_fig_2_3 multi-processor --camera 42,-38,41,10,5.5,2 --size 96x64
