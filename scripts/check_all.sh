#!/usr/bin/env bash
# Runs every check of this repository, and says how long each took. Stages that have passed on the same commit
# are not run again, so a run that was stopped continues where it was.
#   ./scripts/check_all.sh [STAGE...]       all by default; --list prints the names
#   ./scripts/check_all.sh --changed        the stages that guard everything, and those that guard the parts that
#                                           differ from the commit CI_BASE; without it, the last twenty commits
# Reference data is read from SYNTHETIC_DATASET_REFERENCE, ../shared by default; stages that need it are left
# out if it is missing. Logs are beside the workspace (scripts/workspace.sh). Exit code 0 only if all pass.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
cd "$repository"
reference=${SYNTHETIC_DATASET_REFERENCE:-../shared}

# A stage: its name; the paths that it guards ("." for any change, "-" for none: --changed leaves it out); its command.
# Stages run in the order of this list, which begins with those that fail soonest. A command after an "&" keeps no more
# than one core busy: it runs in parallel with its neighbours that also have an "&".
stages=(
  'format     | .  | check_format.sh'
  'api_docs   | ^include/|^docs/Doxyfile | api_docs.sh'
  'tests      | .  | test.sh --all'
  'tidy       | .  | tidy_changed.sh $base $tidy_seconds'
  'reference  | .  | & test_reference_data.sh $reference'
  'gazebo     | .  | & compare_with_gazebo.sh $reference'
  'scans      | ^src/(lidar|world|config|run)/|^plugins/ros_bag/|^scripts/gazebo_scans/ | & compare_scans_with_gazebo.sh $reference'
  'report     | ^scripts/report|^python/|^test/browser/ | & test_report.sh'
  'loaders    | ^plugins/|^include/|^src/api/|^python/|^test/loaders/ | & test_loaders.sh'
  'page       | ^src/programs/setup_assistant/|^src/run/live/|^test/setup_assistant/ | & test_setup_page.sh'
  'twin       | ^src/(motion|scene|label)/|^test/twin/ | & test_twin.sh'
  'preview    | ^src/programs/preview/|^launch/|^test/preview/ | test_preview.sh'
  'egl        | ^src/render/gl/|^cmake/ | test_egl.sh'
  'ros2       | ^src/motion/(bag|ros2)/|^test/ros2/ | test_ros2_bags.sh'
  'faults     | ^src/(output|run)/|^test/faults/ | test_faults.sh --trials 10'
  'soak       | ^src/(output|run)/|^test/faults/ | soak.sh 20000'
  'slurm      | ^scripts/slurm/|^test/slurm/|^src/programs/(merge|generate) | test_slurm.sh'
  'sources    | \.(h|cpp)$ | check_each_source.sh $source_time $changed_sources'
  'address    | ^(include|src|plugins|test)/.*\.(h|cpp)$ | sanitize.sh address $sanitizer_time $changed_programs'
  'thread     | -  | sanitize.sh thread'
  'fuzz       | -  | fuzz.sh 20'
  'bullseye   | -  | test_systems.sh bullseye'
  'trixie     | -  | test_systems.sh trixie'
)
field() {  # STAGE NUMBER
  awk -v number="$2" '{n = split($0, all, / +[|] +/); value = all[number]; sub(/ +$/, "", value); print value}' <<<"$1"
}

names=()
only_changed=false
base=$(git rev-parse --verify --quiet "${CI_BASE:-}^{commit}" || true)
[ -n "$base" ] && [ "$base" != "$(git rev-parse HEAD)" ] || base=$(git rev-list --first-parent --max-count=21 HEAD | tail -n 1)
changed_sources='' changed_programs='' tidy_seconds=1200 source_time='' sanitizer_time=''
case ${1:-} in
  --list)
    for stage in "${stages[@]}"; do field "$stage" 1; done
    exit 0 ;;
  --changed)
    only_changed=true
    changed=$(git diff --name-only "$base" HEAD)
    changed_sources=$(git diff --name-only --diff-filter=d "$base" HEAD -- '*.cpp')
    # If a change affects many rooms, whatever does not fit into these times is left to the run of all checks.
    tidy_seconds=90 source_time='--seconds 300' sanitizer_time='--seconds 420'
    # The test program of a room is named after it; include/ and src/api are tested together.
    changed_programs=$(sed -nE 's:^(src|test)/([^/]+)/.*\.(cpp|h)$:\2:p; s:^plugins/.*:plugins:p; s:^include/.*:api:p' \
      <<<"$changed" | sort -u | while read -r room; do
        grep -qs 'synthetic_dataset_test(' "test/$room/CMakeLists.txt" && echo "test_$room"
      done || true)
    echo "What changed since $(git log -1 --format='%h, %s' "$base"):"
    cut -d/ -f1,2 <<<"$changed" | sort | uniq -c | sort -rn ;;
  *)
    names=("$@") ;;
esac

is_chosen() {  # STAGE
  local name paths
  name=$(field "$1" 1) paths=$(field "$1" 2)
  [[ $1 != *'$reference'* ]] || [ -d "$reference" ] || return 1
  if $only_changed; then
    [[ $1 != *'$changed_sources'* ]] || [ -n "$changed_sources" ] || return 1
    [[ $1 != *'$changed_programs'* ]] || [ -n "$changed_programs" ] || return 1
    [ "$paths" != - ] && grep -qE "$paths" <<<"$changed"
  else
    [ ${#names[@]} -eq 0 ] || printf '%s\n' "${names[@]}" | grep -qx "$name"
  fi
}

state=$workspace-checks/$(git rev-parse HEAD)
$only_changed && state=$state-changed
mkdir -p "$state"
# Results are kept by commit, so they say nothing about uncommitted changes.
git diff --quiet HEAD || rm -f "$state"/*.passed

# Prints and logs the command's output, and writes the seconds that it took to a file named after the result.
run() {  # NAME COMMAND
  local start=$SECONDS result=failed command
  # Expands the variables in the command, which are those of this script.
  eval "command=(\"$here\"/$2)"
  echo "== $1"
  "${command[@]}" 2>&1 | tee "$state/$1.log" && result=passed
  echo $((SECONDS - start)) >"$state/$1.$result"
}

"$here/install_dependencies.sh" git
rm -f "$state"/*.failed
chosen=() before=()
for stage in "${stages[@]}"; do
  ! is_chosen "$stage" || chosen+=("$stage")
done
for stage in "${chosen[@]}"; do
  name=$(field "$stage" 1) command=$(field "$stage" 3)
  if [ -f "$state/$name.passed" ]; then
    before+=("$name")
  elif [[ $command == '& '* ]]; then
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n; done
    (said=$(run "$name" "${command#& }") && echo "$said") &
  else
    wait
    run "$name" "$command"
  fi
done
wait

printf '\n%s\n' "== All checks of $(git log -1 --format='%h, %s')"
failed=0
for stage in "${chosen[@]}"; do
  name=$(field "$stage" 1)
  if [ -f "$state/$name.passed" ]; then
    [[ " ${before[*]} " == *" $name "* ]] && when='passed before, in' || when='passed in'
    printf '%-10s %s %5s s\n' "$name" "$when" "$(cat "$state/$name.passed")"
  else
    failed=$((failed + 1))
    printf '%-10s FAILED in %5s s: %s\n' "$name" "$(cat "$state/$name.failed")" "$state/$name.log"
  fi
done
echo "$SECONDS s in all"
[ ${#chosen[@]} -gt 0 ] && [ "$failed" -eq 0 ]
