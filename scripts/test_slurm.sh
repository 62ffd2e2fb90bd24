#!/usr/bin/env bash
# Makes the example's dataset with a real Slurm of two nodes on this machine: a task's program is
# killed, one is asked to stop, a node fails, and the merged dataset must equal a single run's.
#   ./scripts/test_slurm.sh
# A Slurm already on this machine is not touched. All files are removed, unless something fails.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
# shellcheck source=../test/slurm/cluster.bash
source "$repository/test/slurm/cluster.bash"
time_limit=900  # [s], for everything after the build; it takes some 100 s on an idle machine

if [ "${1:-}" != --built ]; then
  "$here/install_dependencies.sh" slurm-wlm munge
  build_workspace --target generate merge synthetic_dataset_writers
  exec timeout --kill-after=30 "$time_limit" "$here/test_slurm.sh" --built
fi
use_workspace
programs=$workspace/devel/lib/synthetic_dataset
config=$repository/config/example.yaml
settings=("camera/info_file:='$repository/test/slurm/camera.yaml'")
passed=0 failed=0

check() {
  if "${@:2}"; then
    passed=$((passed + 1)) && printf 'passed: %s\n' "$1"
  else
    failed=$((failed + 1)) && printf 'FAILED: %s\n' "$1"
  fi
}

# A check without which the following ones make no sense.
require() {
  local before=$failed
  check "$@"
  [ "$failed" -eq "$before" ] || exit 1
}

finish() {
  local code=$?
  [ "$code" -eq 0 ] || check "the test runs to its end" false
  stop_cluster
  check "no process of the cluster is left" cluster_is_gone
  if [ "$failed" -eq 0 ]; then
    rm -rf "$folder"
  else
    printf 'Logs and datasets: %s\n' "$folder"
  fi
  printf '%s passed, %s failed\n' "$passed" "$failed"
  [ "$failed" -eq 0 ] || exit 1
}

# submit NAME [ARGUMENT...]: sets `array` and `merging` to the jobs' numbers.
submit() {
  IFS=, read -r array merging < <("$here/slurm/submit.sh" "${@:2}" |
    tee "$folder/submit-$1.log" | sed -n 's/.*squeue --jobs=//p')
  [ -n "$merging" ]
}

fact_of_job() {  # JobState or Restarts
  scontrol show job --oneliner "$1" | sed -n "s/.* $2=\([^ ]*\).*/\1/p" | head -n 1
}

job_is() {
  [ "$(fact_of_job "$1" JobState)" = "$2" ]
}

job_was_restarted() {
  [ "$(fact_of_job "$1" Restarts)" -eq "$2" ]
}

job_has_ended() {
  [[ $(fact_of_job "$1" JobState) =~ ^(COMPLETED|FAILED|CANCELLED|TIMEOUT)$ ]]
}

# begun DATASET INDEX COUNT: whether the shard has a scene but is not complete.
begun() {
  /usr/bin/python3 - "$1/manifest.shard-$2-of-$3.sqlite" 2>/dev/null <<'END'
import sqlite3
import sys
database = sqlite3.connect(f'file:{sys.argv[1]}?mode=rw', uri=True)
state = database.execute("SELECT value FROM run WHERE key = 'state'").fetchone()[0]
scenes = database.execute('SELECT count(*) FROM scene').fetchone()[0]
sys.exit(0 if scenes > 0 and state != 'complete' else 1)
END
}

# program_of DATASET INDEX: prints the process that makes this shard.
program_of() {
  pgrep -o -f -- "^[^ ]*/generate .*output_folder:='$1' shard/index:=$2 "
}

signal_program() {
  kill "-$1" "$(program_of "$2" "$3")"
}

# Some formats list absolute paths: all datasets are made in the same folder and then moved.
single_run() {
  timeout 300 "$programs/generate" --config "$config" "${settings[@]}" \
    output_folder:="'$dataset'" &>"$folder/single.log" && mv "$dataset" "$folder/single"
}

indices_on() {
  squeue --noheader --states=RUNNING --jobs="$array" --nodelist="$1" --format=%K
}

# One program is killed, one task is asked to stop, and the other two lose their node.
four_shards_that_are_all_cut_short() {
  local index
  require "four shards are submitted" \
    submit merged "$config" 4 "output_folder:=$dataset" "${settings[@]}"
  for index in 0 1 2 3; do
    require "shard $index is under way" wait_until 120 begun "$dataset" "$index" 4
    require "it halts there" signal_program STOP "$dataset" "$index"
  done
  mapfile -t others < <(indices_on n1)
  require "two of them are on the first node" test "${#others[@]}" -eq 2
  check "a program is killed" signal_program KILL "$dataset" "${others[0]}"
  check "a task is asked to stop, as before its time limit" \
    scancel --batch --signal=TERM "${array}_${others[1]}"
  check "its program goes on" signal_program CONT "$dataset" "${others[1]}"
  check "a node fails" fail_node n2
  check "the node is repaired" repair_node n2
  check "the shards are merged" wait_until 300 job_has_ended "$merging"
  check "the merge succeeded" job_is "$merging" COMPLETED
  for index in 0 1 2 3; do
    check "the task of shard $index was started twice" job_was_restarted "${array}_$index" 1
  done
  check "the merged dataset is the single run's" diff -r "$folder/single" "$dataset"
  require "the same line is submitted again" \
    submit again "$config" 4 "output_folder:=$dataset" "${settings[@]}"
  check "it finds all complete" wait_until 120 job_is "$merging" COMPLETED
  check "the dataset is as it was" diff -r "$folder/single" "$dataset"
  mv "$dataset" "$folder/merged"
}

shards_in_folders_of_their_own() {
  local index
  require "two shards in folders of their own are submitted" submit apart \
    --shards "$folder/shards" "$config" 2 "output_folder:=$dataset" "${settings[@]}"
  check "they are merged" wait_until 300 job_is "$merging" COMPLETED
  for index in 0 1; do
    check "the task of shard $index was started once" job_was_restarted "${array}_$index" 0
  done
  check "their merged dataset is the single run's" diff -r "$folder/single" "$dataset"
}

errors_are_not_repeated() {
  require "a wrong setting is submitted" submit wrong "$config" 1 "output_folder:=$folder/wrong" rate:=1
  check "its task ends" wait_until 120 job_has_ended "${array}_0"
  check "it has failed" job_is "${array}_0" FAILED
  check "it was not started again" job_was_restarted "${array}_0" 0
  check "its log names the setting" \
    grep -q "rate" "$folder/wrong-logs/generate-${array}_0.log"
  check "nothing is merged" wait_until 120 job_is "$merging" CANCELLED
}

restarts_are_bounded() {
  require "a task without restarts is submitted" submit bounded --restarts 0 "$config" 1 \
    "output_folder:=$folder/bounded" "${settings[@]}"
  check "it is under way" wait_until 120 begun "$folder/bounded" 0 1
  check "its program is killed" signal_program KILL "$folder/bounded" 0
  check "it ends" wait_until 120 job_has_ended "${array}_0"
  check "it has failed" job_is "${array}_0" FAILED
  check "its log says why" grep -q 'failed: ended by signal 9' \
    "$folder/bounded-logs/generate-${array}_0.log"
}

# Not below TMPDIR: the path of a socket has at most 107 characters.
folder=$(mktemp -d /tmp/synthetic_dataset_slurm.XXXXXX)
dataset="$folder/the dataset"
mkdir "$folder/tmp"
export TMPDIR=$folder/tmp  # for the leftovers of tasks whose node fails
trap finish EXIT
trap 'exit 143' TERM INT HUP
require "a Slurm of two nodes starts" start_cluster "$folder/cluster"
require "a single run makes the dataset" single_run
four_shards_that_are_all_cut_short
shards_in_folders_of_their_own
errors_are_not_repeated
restarts_are_bounded
