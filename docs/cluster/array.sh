#!/bin/sh
# Measures one shard of a study as a task of a Slurm job array; without Slurm it prints this usage and stops.
#
#   sbatch --array=1-16 array.sh 16 sweep model.csg -o out
#
# The number of shards, 16, is an argument because an array may be repeated in part:
#
#   sbatch --array=3,7-8 array.sh 16 sweep model.csg -o out
#
#SBATCH --job-name=csgsim
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
set -eu
refuse() {
  cat >&2 <<TEXT
array.sh: $1
usage: sbatch --array=1-16 array.sh 16 sweep model.csg -o out
Each task of the array runs csgsim sweep model.csg -o out --shard TASK/16; csgsim gather out then joins the shards.
Without Slurm, run the shards with a loop, xargs or GNU Parallel:
  seq 16 | xargs -P 4 -I{} csgsim sweep model.csg -o out --threads 1 --shard {}/16
TEXT
  exit 2
}
[ "$#" -ge 2 ] || refuse "name the number of shards, a study and its arguments"
case $1 in
  '' | *[!0-9]*) refuse "'$1' is not a number of shards" ;;
esac
[ -n "${SLURM_ARRAY_TASK_ID:-}" ] || refuse "this is not a task of a Slurm job array (SLURM_ARRAY_TASK_ID is not set)"
shards=$1
study=$2
shift 2
exec csgsim "$study" --shard "$SLURM_ARRAY_TASK_ID/$shards" "$@"
