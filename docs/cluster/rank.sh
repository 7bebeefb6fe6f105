#!/bin/sh
# Measures the shard of a process's rank, under an MPI launcher:
#
#   mpirun -n 16 rank.sh sweep model.csg -o out     # Open MPI, MPICH, Intel MPI
#   srun -n 16 rank.sh sweep model.csg -o out       # Slurm
#
# csgsim needs no MPI: the launcher only provides the rank.
set -eu
[ "$#" -ge 1 ] || {
  echo "rank.sh: usage: mpirun -n 16 rank.sh sweep model.csg -o out, or srun -n 16 rank.sh ..." >&2
  exit 2
}
if [ -n "${OMPI_COMM_WORLD_RANK:-}" ]; then
  rank=$OMPI_COMM_WORLD_RANK size=$OMPI_COMM_WORLD_SIZE
elif [ -n "${PMI_RANK:-}" ]; then
  rank=$PMI_RANK size=$PMI_SIZE
elif [ -n "${SLURM_STEP_NUM_TASKS:-}" ] && [ -n "${SLURM_PROCID:-}" ]; then
  rank=$SLURM_PROCID size=$SLURM_STEP_NUM_TASKS
else
  echo "rank.sh: no rank in the environment; start it with mpirun or srun" >&2
  exit 2
fi
study=$1
shift
exec csgsim "$study" --shard "$((rank + 1))/$size" "$@"
