#!/usr/bin/env bash
# sweep_slurm_test.sh ROOT PROGRAM: sweep_slurm.sh on a Slurm of this test's own, two nodes on one host, of which one is killed while it drives; it goes
# on after an interruption; what is merged is one run. In a network namespace; as root, since Slurm's node daemon asks for it.
set -euo pipefail
root=$1
export BANDWAGON=$2
for program in slurmctld slurmd munged sbatch; do
  PATH=$PATH:/usr/sbin command -v $program >/dev/null || { echo "skipped: $program is not here (slurm-wlm, slurmd, munge)" && exit 77; }
done
((EUID == 0)) || { echo "skipped: Slurm's daemons need root" && exit 77; }
if [[ ${3:-} != inside ]]; then
  unshare --net --mount --pid --fork true 2>/dev/null || { echo "skipped: no network namespace here" && exit 77; }
  exec unshare --net --pid --fork --kill-child --mount-proc bash "$0" "$root" "$BANDWAGON" inside
fi

export PATH=$PATH:/usr/sbin
work=$(mktemp -d)
chmod 755 "$work"
trap 'rm -rf "$work"' EXIT
fail() {
  echo "sweep_slurm_test: $*" >&2
  tail -n 5 "$work"/log/* >&2 || true
  exit 1
}
# Slurm looks names up only where there is an address besides the loopback's.
ip link set lo up
ip link add one type veth peer name two
ip address add 10.99.0.1/24 dev one
ip link set one up && ip link set two up
host=$(hostname)
mkdir -p "$work"/{state,n1,n2,log,munge}
head -c 1024 /dev/urandom >"$work/munge/key" && chmod 400 "$work/munge/key"
munged --foreground --force --socket="$work/munge/socket" --key-file="$work/munge/key" --pid-file="$work/munge/pid" \
  --seed-file="$work/munge/seed" --log-file="$work/log/munge" >/dev/null 2>&1 &
export SLURM_CONF=$work/slurm.conf
cat >"$SLURM_CONF" <<C
ClusterName=test
SlurmctldHost=$host(10.99.0.1)
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
SlurmUser=root
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/%n
SlurmctldPidFile=$work/ctld.pid
SlurmdPidFile=$work/%n.pid
SlurmctldLogFile=$work/log/ctld
SlurmdLogFile=$work/log/%n
SlurmctldPort=16817
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdTimeout=5
NodeName=n1 NodeHostname=$host NodeAddr=10.99.0.1 Port=16818 CPUs=1
NodeName=n2 NodeHostname=$host NodeAddr=10.99.0.1 Port=16819 CPUs=1
PartitionName=all Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
C
until_true() { # until_true TENTHS_OF_A_SECOND COMMAND...
  local tenths=$1
  shift
  until "$@"; do
    ((tenths-- > 0)) || return 1
    sleep 0.1
  done
}
until_true 100 test -S "$work/munge/socket" || fail "munge did not come up"
slurmctld -D >/dev/null 2>&1 &
slurmd -D -N n1 >/dev/null 2>&1 &
node=$!
slurmd -D -N n2 >/dev/null 2>&1 &
both_idle() { [[ $(sinfo -h -t idle -o %D 2>/dev/null) == 2 ]]; }
until_true 150 both_idle || fail "the nodes did not come up: $(sinfo 2>&1)"

suite=("$root/config/suites/hallway.yaml" --planners=teb --episode=light --seeds=3..8)
hashes() { grep -o '"samples_sha256": "[0-9a-f]*"' "$1"; }
cd "$work"
"$BANDWAGON" evaluate "${suite[@]}" --json one.json >/dev/null 2>&1

# The first node dies with what it drives. Its job is queued again, and driven on the other one.
"$root/launch_scripts/sweep_slurm.sh" out.json 3 "${suite[@]}" >sweep.log 2>&1 &
sweep=$!
runs_there() { job=$(squeue -h -t R -w n1 -o %A) && [[ -n $job ]] && step=$(pgrep -f "slurmstepd: \[$job"); }
until_true 100 runs_there || fail "nothing runs on the first node"
kill -KILL "$node" "$step"
pkill -KILL -f -- "--shard=1/3" || true
lost() { [[ $(sinfo -h -n n1 -o %t) == down* ]] && [[ -n $(squeue -h -r -t PD -o %i) ]]; }
until_true 900 lost || fail "the job of the lost node was not queued again: $(squeue 2>&1)"
# Slurm would wait two minutes.
for waiting in $(squeue -h -r -t PD -o %i); do scontrol update JobId="$waiting" StartTime=now; done
wait "$sweep" || { cat sweep.log && fail "it failed"; }
[[ $(hashes one.json | wc -l) == 6 ]] || fail "one run has not six drives"
[[ $(hashes one.json) == $(hashes out.json) ]] || fail "merged it is another evaluation"
[[ ! -e out.json.shards ]] || fail "shards are left"

# Shards that are there are not driven again.
mkdir out2.json.shards
for shard in 1 2; do "$BANDWAGON" evaluate "${suite[@]}" --shard=$shard/3 --json out2.json.shards/$shard.json >/dev/null 2>&1; done
"$root/launch_scripts/sweep_slurm.sh" out2.json 3 "${suite[@]}" >resumed.log 2>&1 || { cat resumed.log && fail "resumed it failed"; }
grep -q "2 of 3 shards are there" resumed.log || fail "it began anew"
[[ $(hashes one.json) == $(hashes out2.json) ]] || fail "resumed it is another evaluation"
echo passed
