# Sourced by the batch scripts: runs a program so that a task which dies is started again, a bounded
# number of times.

say() {
  printf 'synthetic_dataset: %s\n' "$1"
}

# begin_task WHAT SETUP RESTARTS: the environment of a task, whatever the node and the submitting shell
# have.
begin_task() {
  local restart=${SLURM_RESTART_COUNT:-0}
  say "$1 on ${SLURMD_NODENAME:-this node}, start $((restart + 1)) of at most $(($3 + 1))"
  # Slurm itself starts a task again after a node's failure: that counts as well.
  if [ "$restart" -gt "$3" ]; then
    say "failed: started again $3 times already; --restarts of submit.sh allows more"
    exit 1
  fi
  export LC_ALL=C  # the node may lack the submitting shell's locale
  # ROS's and Mesa's caches go to the node's own disk: a home folder may be small, far, or read-only,
  # and many tasks would write the same files there.
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  export ROS_HOME=$scratch/ros XDG_CACHE_HOME=$scratch/cache TMPDIR=$scratch
  # Mesa draws with a thread for each of the machine's cores unless limited: here, those of the task.
  export LP_NUM_THREADS=${LP_NUM_THREADS:-${SLURM_CPUS_ON_NODE:-1}}
  set +u  # catkin's file reads variables that may be unset
  # shellcheck disable=SC1090
  source "$2"
  set -u
}

# run_or_requeue RESTARTS PROGRAM [ARGUMENT...]: ends as the program ends, or with the task requeued.
run_or_requeue() {
  local restarts=$1 code=0
  run_to_its_end "${@:2}" || code=$?
  case $code in
    0) ;;
    # An error that the program has reported: a setting, a missing file, a full disk. Another start would
    # meet the same one. When it is mended, the same submit.sh line goes on.
    [1-9] | [1-9][0-9] | 1[01][0-9] | 12[0-7])
      say "failed with exit code $code: not started again, see the message above" ;;
    130) say "interrupted: not started again" ;;
    # A signal: the time limit's, a preemption's, the kernel's when memory is short, a crash's.
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
    signalled=''  # the signal, and not the program's end, may have ended the wait
  done
  trap '' TERM  # what Slurm sends to a task that it requeues
  return "$code"
}

# requeue RESTARTS CODE: has Slurm start this task again, unless it is being ended or has been too often.
requeue() {
  local task=${SLURM_ARRAY_JOB_ID:+${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID} state
  task=${task:-$SLURM_JOB_ID}
  local end="ended by signal $(($2 - 128))"
  if [ "${SLURM_RESTART_COUNT:-0}" -ge "$1" ]; then
    say "failed: $end; started again $1 times already; --restarts of submit.sh allows more"
    return
  fi
  # Of a task that scancel ends, or that Slurm requeues by itself, the state is another one.
  state=$(patiently squeue --noheader --jobs="$task" --format=%T) || state=unknown
  if [ "$state" != RUNNING ]; then
    say "$end; its state is $state: left to Slurm"
  elif patiently scontrol requeue "$task"; then
    say "$end; to be started again"
  else
    say "failed: $end, and Slurm refuses to start the task again"
  fi
}

# patiently COMMAND...: Slurm's controller may be away for some minutes.
patiently() {
  local attempt
  for ((attempt = 0; attempt < 30; ++attempt)); do
    "$@" && return
    sleep 10
  done
  return 1
}
