#!/usr/bin/env bash
# Makes a dataset on a Slurm cluster: COUNT tasks make a shard each, then a job merges them.
#   submit.sh [OPTION...] CONFIG COUNT output_folder:=FOLDER [NAME:=VALUE...] [-- SBATCH_OPTION...]
#
#   CONFIG            settings, as for `generate --config`
#   COUNT             number of shards; each is a task of a job array
#   output_folder:=   where the dataset goes: a folder that all nodes and this machine share. It is
#                     required, as CONFIG may name a different one on each machine
#   NAME:=VALUE       other settings, which override those in CONFIG
#   SBATCH_OPTION     for both jobs: --partition, --account, --time, --mem, --cpus-per-task, ...
#
#   --at-once N       at most N tasks at a time (default: as many as the cluster has room for)
#   --logs FOLDER     where the tasks' logs go (default: the output folder's name with `-logs`)
#   --restarts N      how often a task may be restarted (default: 5)
#   --setup FILE      sourced by each task before anything else: modules, the workspace (default:
#                     setup.bash of the workspace that this script belongs to)
#   --shards FOLDER   each shard in a folder of its own below FOLDER, which is shared as well
#                     (default: all in the output folder)
#
# The same command continues where an earlier one ended. docs/cluster.md says what happens when.
set -euo pipefail
scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

fail() {
  printf 'submit.sh: %s\n' "$1" >&2
  exit 1
}

usage() {
  sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"
}

is_count_from_1() {
  [[ $1 =~ ^[1-9][0-9]{0,5}$ ]]
}

# find_program NAME: prints its path: beside this script in an install space, elsewhere in a workspace.
find_program() {
  if [ -x "$scripts/$1" ]; then
    printf '%s\n' "$scripts/$1"
  else
    catkin_find --first-only --libexec synthetic_dataset "$1" 2>/dev/null ||
      fail "the program '$1' is not found; build the workspace and source its setup.bash"
  fi
}

read_options() {
  at_once='' logs='' restarts=5 setup='' shards=''
  while [[ ${1:-} == -* ]]; do
    case $1 in
      -h | --help) usage && exit 0 ;;
      --at-once | --logs | --restarts | --setup | --shards)
        [ $# -ge 2 ] || fail "$1 needs a value" ;;
      *) fail "unknown option '$1'; sbatch's own options come last, after --" ;;
    esac
    case $1 in
      --at-once) at_once=$2 ;;
      --logs) logs=$(realpath -m -- "$2") ;;
      --restarts) restarts=$2 ;;
      --setup) setup=$(realpath -m -- "$2") ;;
      --shards) shards=$(realpath -m -- "$2") ;;
    esac
    shift 2
  done
  arguments=("$@")
}

read_arguments() {
  [ $# -ge 2 ] || fail "CONFIG and COUNT are missing; submit.sh --help says more"
  config=$(realpath -m -- "$1") count=$2
  shift 2
  output='' settings=() sbatch_options=()
  while [ $# -gt 0 ]; do
    case $1 in
      --) shift && sbatch_options=("$@") && return ;;
      output_folder:=?*)
        output=${1#output_folder:=}
        [[ $output != '~'/* ]] || output=$HOME/${output:2}  # the shell does not expand ~ after :=
        output=$(realpath -m -- "$output") ;;
      shard:=* | shard/*:=*) fail "found $1; the shards are numbered by this script" ;;
      ?*:=*) settings+=("$1") ;;
      *) fail "found '$1'; it should be NAME:=VALUE, or stand after --" ;;
    esac
    shift
  done
}

check() {
  [[ -f $config && -r $config ]] || fail "$config: no such file, or not to be read"
  is_count_from_1 "$count" || fail "COUNT: found '$count'; it should be a number from 1"
  is_count_from_1 "${at_once:-1}" || fail "--at-once: found '$at_once'; it should be a number from 1"
  [[ $restarts =~ ^[0-9]{1,6}$ ]] || fail "--restarts: found '$restarts'; it should be a number from 0"
  [ -n "$output" ] || fail "output_folder:=FOLDER is missing"
  [[ $logs != *\\* ]] || fail "--logs: found '$logs'; Slurm takes no backslash in it"
  [[ -f $setup && -r $setup ]] || fail "$setup: no such file, or not to be read; name one with --setup"
  command -v sbatch >/dev/null || fail "sbatch is not found; this machine has no Slurm"
}

# submit LOG OPTION... SCRIPT ARGUMENT...: prints the job's number. Later options take precedence, so the
# user's options come after the defaults and before those on which the two jobs depend.
submit() {
  local answer
  answer=$(sbatch --parsable --output="${logs//%/%%}/$1" "${sbatch_options[@]}" "${@:2}") &&
    printf '%s\n' "${answer%%;*}"  # the cluster's name follows if there are several
}

read_options "$@"
read_arguments "${arguments[@]}"
logs=${logs:-$output-logs}
generate=$(find_program generate)
merge=$(find_program merge)
# In a workspace as in an install space, the program is PREFIX/lib/synthetic_dataset/generate.
setup=${setup:-${generate%/*/*/*}/setup.bash}
check
mkdir -p -- "$logs" "$output"

shard_folders=()
if [ -n "$shards" ]; then
  for ((index = 0; index < count; ++index)); do
    shard_folders+=("$shards/shard-$index-of-$count")
  done
fi

# Tasks inherit the environment, which contains other job numbers if this script itself runs in a job.
unset SLURM_RESTART_COUNT SLURM_ARRAY_JOB_ID SLURM_ARRAY_TASK_ID
array=$(submit %x-%A_%a.log --array="0-$((count - 1))${at_once:+%$at_once}" "$scripts/array.sbatch" \
  "$scripts" "$setup" "$restarts" "$generate" "$config" "$count" "$shards" "$output" \
  "${settings[@]}")
merging=$(submit %x-%j.log --dependency="afterok:$array" --kill-on-invalid-dep=yes \
  "$scripts/merge.sbatch" "$scripts" "$setup" "$restarts" "$merge" "$output" \
  "${shard_folders[@]}") || { scancel "$array"; fail "the job that merges was refused; the array is cancelled"; }

cat <<END
Job $array makes $count shards, then job $merging merges them into $output
To look at them: squeue --jobs=$array,$merging
Their logs:      $logs
To end them:     scancel $array $merging    (the same line again goes on from there)
END
