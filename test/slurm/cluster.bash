# Sourced: a real Slurm of two nodes on this machine, below a folder of its own. It neither needs nor
# touches a Slurm, a munge, or their services that the machine may have.

# start_cluster FOLDER: answers 1 unless both nodes are ready.
start_cluster() {
  cluster=$1
  daemons=()
  # FOLDER lies in a folder of the script; munged wants its socket's folder to be open to all, and its key closed to all others.
  mkdir -p "$cluster/state" "$cluster/n1" "$cluster/n2"
  chmod 755 "${cluster%/*}" "$cluster"
  (umask 077 && head -c 1024 /dev/urandom >"$cluster/munge.key")
  # Settings for another Slurm, or of a job of it that this script may run in.
  unset "${!SLURM@}" "${!SBATCH_@}" "${!SQUEUE_@}" "${!SINFO_@}" "${!SCANCEL_@}" "${!SCONTROL_@}"
  # The environment is how the cluster's commands find it, and how its processes are known.
  export SLURM_CONF=$cluster/slurm.conf
  write_cluster_settings >"$SLURM_CONF"
  start_daemon munged --foreground --force --num-threads=2 --key-file="$cluster/munge.key" \
    --socket="$cluster/munge.socket" --pid-file="$cluster/munged.pid" \
    --seed-file="$cluster/munge.seed" --log-file="$cluster/munged.log"
  wait_until 20 test -S "$cluster/munge.socket" || return 1
  start_daemon slurmctld -D
  wait_until 20 controller_answers || return 1
  start_daemon slurmd -D -N n1
  start_daemon slurmd -D -N n2
  wait_until 30 nodes_are_idle
}

write_cluster_settings() {
  local ports
  mapfile -t ports < <(free_ports 3)
  cat <<END
ClusterName=one_machine
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=${ports[0]}
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
CredType=cred/munge
# A job that is requeued may start again when its old credential has expired [s].
AuthInfo=socket=$cluster/munge.socket,cred_expire=5
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/%n
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd-%n.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
# Nodes are as they are described here, whatever cores the machine has.
SlurmdParameters=config_overrides
SchedulerParameters=batch_sched_delay=1,sched_interval=2,bf_interval=2
KillWait=5
NodeName=n1 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=${ports[1]} CPUs=2
NodeName=n2 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=${ports[2]} CPUs=2
PartitionName=all Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
END
}

# free_ports COUNT: one a line.
free_ports() {
  /usr/bin/python3 - "$1" <<'END'
import socket
import sys
sockets = [socket.socket() for _ in range(int(sys.argv[1]))]
for each in sockets:
    each.bind(('127.0.0.1', 0))
for each in sockets:
    print(each.getsockname()[1])
END
}

start_daemon() {
  "$@" >>"$cluster/daemons.log" 2>&1 </dev/null &
  daemons+=($!)
  disown  # or bash would report that one was killed
}

controller_answers() {
  scontrol ping 2>/dev/null | grep -q 'is UP'
}

nodes_are_idle() {
  [ "$(sinfo --noheader --format=%T%D 2>/dev/null)" = idle2 ]
}

# wait_until SECONDS COMMAND...: answers 1 if the command has not succeeded by then.
wait_until() {
  local end=$((SECONDS + $1))
  until "${@:2}"; do
    [ "$SECONDS" -lt "$end" ] || return 1
    sleep 0.1
  done
}

# fail_node NAME: as if its power was cut. The controller would notice within SlurmdTimeout, and is told.
fail_node() {
  # Those that watch over a job come first: they would tell of its end.
  mapfile -t pids < <(watchers_of_node "$1"; processes_of_node "$1")
  kill -KILL "${pids[@]}" && scontrol update "NodeName=$1" State=DOWN Reason="power cut"
}

repair_node() {
  start_daemon slurmd -D -N "$1"
  scontrol update "NodeName=$1" State=RESUME
}

watchers_of_node() {
  local job pid
  for job in $(squeue --noheader --states=RUNNING --nodelist="$1" --format=%A); do
    for pid in $(cluster_processes); do
      [[ $(command_of "$pid") != "slurmstepd: [$job."* ]] || echo "$pid"
    done
  done
}

processes_of_node() {
  local pid
  for pid in $(cluster_processes); do
    if [[ $(command_of "$pid") == "slurmd -D -N $1 " ]] ||
      grep -qzFx "SLURMD_NODENAME=$1" "/proc/$pid/environ" 2>/dev/null; then echo "$pid"; fi
  done
}

command_of() {
  tr '\0' ' ' 2>/dev/null <"/proc/$1/cmdline" || true
}

# Ends all that start_cluster and its jobs started, and nothing else.
stop_cluster() {
  local pid
  kill -TERM "${daemons[@]}" 2>/dev/null || true
  wait_until 5 cluster_is_gone || true
  for pid in $(cluster_processes); do kill -KILL "$pid" 2>/dev/null || true; done
}

cluster_is_gone() {
  [ -z "$(cluster_processes)" ]
}

# The daemons and what they started: what was born with this cluster's settings in its environment. This
# shell was not.
cluster_processes() {
  local environment pid
  for environment in /proc/[0-9]*/environ; do
    pid=${environment#/proc/} pid=${pid%/environ}
    if grep -qzFx "SLURM_CONF=$SLURM_CONF" "$environment" 2>/dev/null; then echo "$pid"; fi
  done
}
