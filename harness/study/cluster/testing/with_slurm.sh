#!/usr/bin/env bash
# Runs a command beside a Slurm cluster of its own: with_slurm.sh NODES COMMAND [ARGUMENT...]
#
# The "nodes" node1, node2, ... are slurmd processes on the loopback address of this machine, one CPU each; jobs in the partition urgent
# preempt those in main. Everything runs in a
# process namespace of its own that ends with this script, however it ends: no daemon and no job is left. The files are in
# $SLURM_TEST_FOLDER, which is removed. Exit code: the command's; 77, with the reason, where no Slurm can be started.
set -euo pipefail

skip() { echo "skipped: $*"; exit 77; }

if [ "${1-}" != --inside ]; then
  [ $# -ge 2 ] || { echo "usage: with_slurm.sh NODES COMMAND [ARGUMENT...]" >&2; exit 2; }
  [ "$(id -u)" = 0 ] || skip "starting a Slurm cluster needs root"
  for program in slurmctld slurmd munged unshare; do
    [ -n "$(type -P "$program")" ] || skip "$program is not installed (Debian packages slurm-wlm and munge)"
  done
  unshare --pid --fork --kill-child --mount-proc true 2>/dev/null || skip "no process namespace can be made here"
  exec unshare --pid --fork --kill-child --mount-proc -- "$0" --inside "$@"
fi

nodes=$2
shift 2
folder=$(mktemp -d "${TMPDIR:-/tmp}/mwt_slurm_XXXXXX")
trap 'rm -rf "$folder"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
chmod 755 "$folder"
export SLURM_TEST_FOLDER=$folder SLURM_CONF=$folder/slurm.conf

# A free range of ports: for the controller, then one for each node. Several clusters may run at a time.
is_free() { ! (exec 3<>"/dev/tcp/127.0.0.1/$1") 2>/dev/null; }
for port in $(shuf -i 20000-31000 -n 50); do
  all_free=yes
  for offset in $(seq 0 "$nodes"); do is_free $((port + offset)) || all_free=no; done
  [ "$all_free" = no ] || break
done

cat >"$SLURM_CONF" <<CONF
ClusterName=mwt
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort=$port
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket,cred_expire=5
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.%n.pid
SlurmdSpoolDir=$folder/spool.%n
StateSaveLocation=$folder/state
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
KillWait=5
MinJobAge=3600
SlurmdTimeout=10
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
SchedulerParameters=batch_sched_delay=0,sched_interval=2,bf_interval=2
NodeName=node[1-$nodes] NodeHostname=localhost NodeAddr=127.0.0.1 Port=[$((port + 1))-$((port + nodes))] CPUs=1 RealMemory=16000 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP PriorityTier=1
PartitionName=urgent Nodes=ALL MaxTime=INFINITE State=UP PriorityTier=2
CONF

# Temporary files apart from those of programs outside, which take this namespace's process ids for their own.
export TMPDIR=$folder/tmp
mkdir "$folder/state" "$TMPDIR"
(umask 077 && head -c 1024 /dev/urandom >"$folder/munge.key")
munged --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" --pid-file="$folder/munged.pid" \
  --log-file="$folder/munged.log" --seed-file="$folder/munged.seed" >"$folder/munged.out" 2>&1 ||
  skip "munged does not start: $(tail -n 1 "$folder/munged.out" "$folder/munged.log")"
slurmctld >"$folder/slurmctld.out" 2>&1 || skip "slurmctld does not start: $(tail -n 1 "$folder/slurmctld.out")"
for node in $(seq "$nodes"); do
  mkdir "$folder/spool.node$node"
  slurmd -N "node$node" >"$folder/slurmd.out" 2>&1 || skip "slurmd does not start: $(tail -n 1 "$folder/slurmd.out")"
done
for _ in $(seq 60); do
  [ "$(sinfo --noheader --Node --partition=main --states=idle 2>/dev/null | wc -l)" != "$nodes" ] || ready=yes
  [ -z "${ready-}" ] || break
  sleep 0.5
done
[ -n "${ready-}" ] || skip "the nodes do not come up: $(tail -n 1 "$folder/slurmctld.log")"

code=0
"$@" || code=$?
exit "$code"
