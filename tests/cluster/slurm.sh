#!/bin/sh
# A local Slurm with a controller and two nodes: a study runs on it as an array of 16 tasks, a node is killed in the
# middle with everything that runs on it, and the gathered results must equal those of a single process, byte for byte.
# Then the same with srun, mpirun and GNU Parallel.
#
#   tests/cluster/slurm.sh CSGSIM [LOG]      as root; Debian: slurmctld slurmd slurm-client munge parallel openmpi-bin
set -eu

csgsim=$(realpath "$1")
here=$(realpath "$(dirname "$0")/../..")
log=$(realpath -m "${2:-/dev/null}")
: >"$log"
shards=16
work=$(mktemp -d)
PATH=$(dirname "$csgsim"):$PATH
export PATH SLURM_CONF="$work/slurm.conf"
pids=""

clean_up() {
  for pid in $pids; do kill -9 "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
  rm -rf "$work"
}
trap clean_up EXIT
trap 'exit 1' INT TERM

# Prints a text on the terminal and to the log, without this computer's paths.
say() { printf '%s\n' "$*" | sed "s|$work|WORK|g; s|$here|.|g" | tee -a "$log"; }

# Runs a command and prints it with its output.
show() {
  say "\$ $*"
  "$@" >"$work/shown" 2>&1 || { code=$?; sed "s|$work|WORK|g" "$work/shown" | tee -a "$log"; return "$code"; }
  sed "s|$work|WORK|g; s|$here|.|g" "$work/shown" | tee -a "$log"
}

fail() {
  say "FAILED: $*"
  tail -n 30 "$work"/*.log >&2 || true
  exit 1
}

# wait_for SECONDS WHAT CONDITION...
wait_for() {
  end=$(($(date +%s) + $1)) what=$2
  shift 2
  until "$@"; do
    [ "$(date +%s)" -lt "$end" ] || fail "timeout waiting for $what"
    sleep 0.2
  done
}

start_slurm() {
  mkdir -m 700 "$work/munge"
  mkdir "$work/state" "$work/node1" "$work/node2"
  dd if=/dev/urandom of="$work/munge/key" bs=1024 count=1 2>/dev/null
  chmod 400 "$work/munge/key"
  munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge/socket" --pid-file="$work/munge/pid" \
    --log-file="$work/munge/munged.log" --seed-file="$work/munge/seed" 2>"$work/munged.log" &
  pids="$pids $!"
  cat >"$SLURM_CONF" <<CONF
ClusterName=csgsim
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmctldPort=16817
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
StateSaveLocation=$work/state
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/%n/slurmd.pid
SlurmdSpoolDir=$work/%n
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/%n.log
SlurmdParameters=config_overrides
SlurmdTimeout=10
ReturnToService=1
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_min_interval=100000
JobRequeue=1
NodeName=node1 NodeAddr=127.0.0.1 Port=16818 CPUs=1
NodeName=node2 NodeAddr=127.0.0.1 Port=16819 CPUs=1
PartitionName=all Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
CONF
  slurmctld -D -c >"$work/slurmctld.out.log" 2>&1 &
  pids="$pids $!"
  start_node node1
  start_node node2
}

# A node is a separate process namespace: killing its first process ends everything that runs there, like a power
# failure.
start_node() {
  unshare --pid --fork --mount-proc --kill-child slurmd -D -N "$1" >"$work/$1.out.log" 2>&1 &
  eval "$1=$!"
  pids="$pids $!"
}

node_is() { sinfo -h -N -n "$1" -o %T 2>/dev/null | grep -qx "$2\*\?"; }
both_idle() { node_is node1 idle && node_is node2 idle; }
finished() { [ "$(find "$1/shards" -name '*.shard' 2>/dev/null | wc -l)" -ge "$2" ]; }
queue_is_empty() { [ -z "$(squeue -h -t PD,R,CF,CG,S,RQ,RH 2>/dev/null || echo unknown)" ]; }
shard_on() { squeue -h -t R -o "%N %K" | sed -n "s/^$1 //p"; }
rows_of() { cat "$work/array/shards/sweep-$(printf %02d "$1")-of-$shards".*.shard 2>/dev/null | grep -c '^[0-9]' || true; }
# Whether the shard on a node has measured some of its points, but not all.
is_in_the_middle() {
  on_node=$(shard_on "$1")
  [ -n "$on_node" ] && [ "$(rows_of "$on_node")" -ge 2 ] && [ "$(rows_of "$on_node")" -le $((points / shards - 3)) ]
}

same() {
  (cd "$work/one" && find . -type f | sort | xargs sha256sum) >"$work/one.sums"
  (cd "$1" && find . -path ./shards -prune -o -type f -print | sort | xargs sha256sum) >"$work/other.sums"
  cmp "$work/one.sums" "$work/other.sums" || fail "$1 differs from the results of one process"
  say "the $(wc -l <"$work/one.sums") files in $1 equal those of one process, byte for byte"
}

study="sweep $here/tests/models/terrain_vehicle.csg --camera 560,-590,420,-5,0,68 --projection perspective"
study="$study --z-bits 16,18,20 --pruning all,no-space,no-separation,no-hidden,none"
cd "$work"

say "== a single process"
# shellcheck disable=SC2086
csgsim $study -o "$work/one" >"$work/one.txt"
points=$(tail -n +2 "$work/one/sweep.csv" | wc -l)
say "$points points"

say "== a Slurm array of $shards tasks on two nodes; one node is killed"
show slurmctld -V
start_slurm
wait_for 60 "a Slurm with two nodes" both_idle
show sinfo -N -o "%N %T %c"
# shellcheck disable=SC2086
show sbatch --array=1-$shards -o "$work/task-%a.txt" "$here/docs/cluster/array.sh" $shards $study --threads 1 -o "$work/array"
wait_for 300 "a third of the shards" finished "$work/array" 6
wait_for 300 "a shard in its middle on node2" is_in_the_middle node2
# unshare's child is the first process of the namespace; killing it kills all others.
eval "pgrep -P \$node2" | xargs kill -9
victims=$(shard_on node2)
say "kill -9: node2, and on it shard $victims, which has $(rows_of "$victims") rows"
show squeue -h -o "%.8i %.10T %N"
wait_for 120 "node2 down" node_is node2 down
show sinfo -N -o "%N %T %c"
for victim in $victims; do
  show sh -c "squeue -h -r -o '%K %T %r restarts %S' | grep '^$victim ' || true"
done
# Slurm delays the restart of a job from a lost node; that is unnecessary here.
wait_for 600 "the end of the array" queue_is_empty
show sh -c "grep -h -o 'requeue .*node2.*\|Requeuing.*\|node node2 .*down.*\|Killing JobId.*' slurmctld.log | sed 's/due to.*//' | sort | uniq -c"
for victim in $victims; do show cat "$work/task-$victim.txt"; done
show csgsim gather "$work/array" --missing
rows=$(cat "$work"/array/shards/*.shard | grep -c '^[0-9]')
say "$rows rows for $points points in $(find "$work/array/shards" -name '*.shard' | wc -l) files of $shards shards"
[ "$rows" -eq "$points" ] || fail "expected a row for each point"
csgsim gather "$work/array" >"$work/array.txt" || fail "gather failed"
sed "s|$work/array|$work/one|" "$work/array.txt" | cmp - "$work/one.txt" || fail "the printed text differs"
same "$work/array"

say "== srun, after node2 has come back"
start_node node2
wait_for 60 "node2 idle" both_idle
show srun -n 2 -N 2 -o "$work/srun-%t.txt" "$here/docs/cluster/rank.sh" $study --threads 1 -o "$work/srun"
show cat "$work/srun-0.txt" "$work/srun-1.txt"
csgsim gather "$work/srun" >/dev/null
same "$work/srun"

say "== mpirun"
show mpirun --allow-run-as-root --oversubscribe -n 4 "$here/docs/cluster/rank.sh" $study --threads 1 -o "$work/mpi"
csgsim gather "$work/mpi" >/dev/null
same "$work/mpi"

say "== GNU Parallel"
show sh -c "seq $shards | parallel --will-cite -j 2 -k csgsim $study --threads 1 --shard {}/$shards -o $work/parallel"
csgsim gather "$work/parallel" >/dev/null
same "$work/parallel"
say "no point lost or duplicated"
