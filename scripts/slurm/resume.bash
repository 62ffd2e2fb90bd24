# Sourced by the batch scripts: runs a program so that a task which dies is restarted, a limited
# number of times.

say() {
  printf 'synthetic_dataset: %s\n' "$1"
}

# begin_task WHAT SETUP RESTARTS: sets up the same environment for a task whatever the node and the
# submitting shell have.
begin_task() {
  local restart=${SLURM_RESTART_COUNT:-0}
  say "$1 on ${SLURMD_NODENAME:-this node}, start $((restart + 1)) of at most $(($3 + 1))"
  # Restarts by Slurm itself, after a node failure, count as well.
  if [ "$restart" -gt "$3" ]; then
    say "failed: started again $3 times already; --restarts of submit.sh allows more"
    exit 1
  fi
  export LC_ALL=C  # the node may lack the submitting shell's locale
  # ROS's and Mesa's caches go to the node's own disk: a home folder may be small, slow to reach or
  # read-only, and many tasks would write the same files there.
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  export ROS_HOME=$scratch/ros XDG_CACHE_HOME=$scratch/cache TMPDIR=$scratch
  # Unless limited, Mesa draws with one thread for each core of the machine, not of the task.
  export LP_NUM_THREADS=${LP_NUM_THREADS:-${SLURM_CPUS_ON_NODE:-1}}
  set +u  # catkin's file reads variables that may be unset
  # shellcheck disable=SC1090
  source "$2"
  set -u
}

# run_or_requeue RESTARTS PROGRAM [ARGUMENT...]: exits as the program does, possibly after requeuing the task.
run_or_requeue() {
  local restarts=$1 code=0
  run_to_its_end "${@:2}" || code=$?
  case $code in
    0) ;;
    # An error that the program has reported: a setting, a missing file, a full disk. A restart would
    # run into it again. Once it is fixed, the same submit.sh line continues.
    [1-9] | [1-9][0-9] | 1[01][0-9] | 12[0-7])
      say "failed with exit code $code: not started again, see the message above" ;;
    130) say "interrupted: not started again" ;;
    # A signal: from the time limit, a preemption, the kernel when memory runs out, or a crash.
    *) requeue "$restarts" "$code" ;;
  esac
  exit "$code"
}

# run_to_its_end PROGRAM [ARGUMENT...]: passes SIGTERM on and waits for the program, which finishes its scene.
run_to_its_end() {
  local code program='' signalled=''
  trap 'signalled=yes; [ -z "$program" ] || kill -TERM "$program" 2>/dev/null || true' TERM
  "$@" &
  program=$!
  [ -z "$signalled" ] || kill -TERM "$program" 2>/dev/null || true
  while true; do
    code=0
    wait "$program" || code=$?
    [ -n "$signalled" ] || break
    signalled=''  # `wait` may have returned because of the signal, not because the program ended
  done
  trap '' TERM  # Slurm sends it to a task that it requeues
  return "$code"
}

# requeue RESTARTS CODE: has Slurm restart this task, unless it is being ended or was restarted too often.
requeue() {
  local task=${SLURM_ARRAY_JOB_ID:+${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID} state
  task=${task:-$SLURM_JOB_ID}
  local end="ended by signal $(($2 - 128))"
  if [ "${SLURM_RESTART_COUNT:-0}" -ge "$1" ]; then
    say "failed: $end; started again $1 times already; --restarts of submit.sh allows more"
    return
  fi
  # A task that scancel ends, or that Slurm requeues by itself, is in another state.
  state=$(patiently squeue --noheader --jobs="$task" --format=%T) || state=unknown
  if [ "$state" != RUNNING ]; then
    say "$end; its state is $state: left to Slurm"
  elif patiently scontrol requeue "$task"; then
    say "$end; to be started again"
  else
    say "failed: $end, and Slurm refuses to start the task again"
  fi
}

# patiently COMMAND...: retries, as Slurm's controller may not answer for some minutes.
patiently() {
  local attempt
  for ((attempt = 0; attempt < 30; ++attempt)); do
    "$@" && return
    sleep 10
  done
  return 1
}
