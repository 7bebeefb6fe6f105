#!/bin/sh
# Measures one shard of a study as a task of a Slurm job array:
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
shards=$1
study=$2
shift 2
exec csgsim "$study" --shard "$SLURM_ARRAY_TASK_ID/$shards" "$@"
