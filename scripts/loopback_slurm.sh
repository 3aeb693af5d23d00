#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A Slurm of one node on this machine, of the user who starts it, for tests of batches.
#   scripts/loopback_slurm.sh start FOLDER     prints what to export; FOLDER must not exist
#   scripts/loopback_slurm.sh stop FOLDER      kills it with all its jobs and removes FOLDER
# Needs slurmctld, slurmd, slurm-client and munge. Nothing outside FOLDER is read or changed: an installed Slurm goes on.
set -euo pipefail
export PATH=$PATH:/usr/sbin:/sbin

fail() { printf 'loopback_slurm.sh: %s\n' "$*" >&2; exit 1; }
[ $# = 2 ] || { sed -n '5,8p' "$0" | sed 's/^# \{0,1\}//'; exit 2; }
folder=$(realpath -m "$2")

# Its daemons, known by a word in their environment, and all that descends from them.
processes() {
  local found
  found=$(grep -slzx "PLACODE_LOOPBACK_SLURM=$folder" /proc/[0-9]*/environ | cut -d/ -f3 || true)
  while [ -n "$found" ]; do
    echo "$found"
    found=$(pgrep -P "$(paste -sd, <<<"$found")" || true)
  done
}

# Everything at once, as power would.
stop() {
  local found
  for _ in $(seq 50); do
    found=$(processes)
    [ -n "$found" ] || break
    xargs kill -KILL 2>/dev/null <<<"$found" || true
    sleep 0.05
  done
  rm -rf "$folder"
}

free_ports() {
  python3 -c '
import socket
held = [socket.socket() for _ in range(2)]
for s in held: s.bind(("127.0.0.1", 0))
print(*(s.getsockname()[1] for s in held))'
}

write_conf() {
  local ports user host
  read -r -a ports <<<"$(free_ports)"
  user=$(id -un)
  host=$(hostname -s)
  cat >"$folder/slurm.conf" <<CONF
ClusterName=loopback
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
SlurmctldPort=${ports[0]}
SlurmdPort=${ports[1]}
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
SwitchType=switch/none
SchedulerParameters=sched_interval=1,batch_sched_delay=0
ReturnToService=2
MaxArraySize=10001
MaxJobCount=20000
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
  # It looks for control groups even though nothing here uses them, and for those of version 2 it wants systemd.
  echo "CgroupPlugin=cgroup/v1" >"$folder/cgroup.conf"
}

give_up() {
  tail -n 5 "$folder"/*.log "$folder/munged.said" >&2 2>/dev/null || true
  stop
  fail "$1"
}

start() {
  local program
  for program in munged slurmctld slurmd sbatch; do
    command -v "$program" >/dev/null || fail "$program is missing: apt-get install slurmctld slurmd slurm-client munge"
  done
  [ ! -e "$folder" ] || fail "$folder: exists; name a folder that does not"
  (umask 077; mkdir -p "$folder" "$folder/state" "$folder/spool")
  trap 'give_up "it did not start: the reason stands above"' ERR
  local marked=(env "PLACODE_LOOPBACK_SLURM=$folder")
  (umask 077; head -c 1024 /dev/urandom >"$folder/munge.key")
  # --force: it would refuse a socket below a folder of other rights, as /tmp is.
  "${marked[@]}" munged --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" --pid-file="$folder/munged.pid" \
    --log-file="$folder/munged.log" --seed-file="$folder/munged.seed" 2>"$folder/munged.said"
  write_conf
  export SLURM_CONF=$folder/slurm.conf
  "${marked[@]}" slurmctld -f "$SLURM_CONF" -c
  "${marked[@]}" slurmd -f "$SLURM_CONF"
  for _ in $(seq 300); do
    ! sinfo --noheader -o '%T' 2>/dev/null | grep -qx idle || { echo "export SLURM_CONF=$SLURM_CONF"; return; }
    sleep 0.1
  done
  give_up "the node did not become idle within 30 s"
}

case "$1" in
  start) start ;;
  stop) stop ;;
  *) fail "\"$1\": expected start or stop" ;;
esac
