#!/usr/bin/env bash
# Runs the unit tests under clang's sanitizers; exit code 0 only if all pass and nothing is reported.
#   ./scripts/sanitize.sh [address|thread|all [PART/PARTS]]     all by default
# PART/PARTS: 2/4 has every fourth program, from the second on.
# address: every test program, under AddressSanitizer (with leaks) and UndefinedBehaviorSanitizer.
# thread:  the programs in which threads work, under ThreadSanitizer.
# The builds and each program's log lie beside the workspace (scripts/workspace.sh). What is known
# of other people's libraries, and no fault of this code, is named in sanitizers/*.txt.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
kinds=("${1:-all}")
part=${2:-1/1}
[ "${kinds[0]}" != all ] || kinds=(address thread)

# The test programs in which threads work; more code with threads, more names here.
threaded=(test_output)
# Thousands of runs of readers that other tests run too, and comparisons by brute force: under a
# sanitizer they take half of the time and show nothing that the others do not.
brute_force='ShadowRaster.HasTheLeastDepth*:*LensRendering.MarkersLie*:*RollingPicture.ShowsInEachRow*'
brute_force+=':Room.ThroughALensIsTheMeanOfManyRays:PanoramaLight.IsBlurredByTheLobe*'
export GTEST_FILTER="-*TamperedValues*:$brute_force"
# These take longest, so they start first, and each of four parts has one.
longest=(test_render test_run test_world test_output)
mapfile -t every < <(printf "%s\n" "${longest[@]}"; grep -rhoP '^synthetic_dataset_test\(\K\w+' "$repository/test" \
  --include=CMakeLists.txt | sed 's/^/test_/' | sort | grep -vxF "$(printf "%s\n" "${longest[@]}")")
mapfile -t every < <(printf "%s\n" "${every[@]}" | awk -v part="${part%/*}" -v parts="${part#*/}" 'NR % parts == part % parts')

"$here/install_dependencies.sh" clang libclang-rt-14-dev llvm-14
# What users' machines have in these must not change the result.
unset GAZEBO_MODEL_PATH GZ_SIM_RESOURCE_PATH IGN_GAZEBO_RESOURCE_PATH SDF_PATH GAZEBO_RESOURCE_PATH
export ASAN_OPTIONS=detect_leaks=1:detect_stack_use_after_return=1:strict_init_order=1:check_initialization_order=1
export LSAN_OPTIONS=print_suppressions=0:suppressions=$here/sanitizers/leaks.txt
export UBSAN_OPTIONS=print_stacktrace=1
export TSAN_OPTIONS=second_deadlock_stack=1:suppressions=$here/sanitizers/threads.txt

folder_of() {  # KIND
  local beside=${workspace/workspace-/sanitizer-}
  [ "$beside" != "$workspace" ] || beside=$workspace-sanitizer
  echo "$beside-$1"
}

build() {  # KIND FLAGS PROGRAMS...
  local folder kind=$1 flags="-O1 -gline-tables-only -fno-omit-frame-pointer -D_GLIBCXX_ASSERTIONS $2"
  shift 2
  folder=$(folder_of "$kind")
  mkdir -p "$folder/logs"
  cmake -S "$repository" -B "$folder/build" -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
    -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$flags" -DPYTHON_EXECUTABLE=/usr/bin/python3 \
    -DPython3_EXECUTABLE=/usr/bin/python3 >"$folder/logs/configure.log" 2>&1 ||
    { tail -20 "$folder/logs/configure.log"; exit 1; }
  cmake --build "$folder/build" --parallel "$(nproc)" --target "$@"
}

# One line for a program, and the log's end where something is wrong.
run() {  # FOLDER PROGRAM
  local log=$1/logs/$2.log start=$SECONDS status=0 passed failed
  (cd "$repository/test" && "$1/build/devel/lib/synthetic_dataset_tests/$2") >"$log" 2>&1 || status=$?
  passed=$(grep -c '^\[       OK \]' "$log" || true)
  failed=$(grep -c '^\[  FAILED  \] .* ms)$' "$log" || true)
  [ "$status" -eq 0 ] || [ "$failed" -gt 0 ] || failed=1  # it died, or something is reported at its end
  printf '%-22s %5s passed %3s failed %5s s\n' "$2" "$passed" "$failed" $((SECONDS - start))
  [ "$failed" -gt 0 ] || return 0
  grep -E -m 3 -A 25 ': Failure$|ERROR: |WARNING: |runtime error: ' "$log" || tail -5 "$log"
  echo "  see $log"
}

run_all() {  # KIND PROGRAMS...
  local folder program
  folder=$(folder_of "$1")
  echo "== $1"
  for program in "${@:2}"; do
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n; done
    run "$folder" "$program" >"$folder/logs/$program.result" &
  done
  wait
  for program in "${@:2}"; do
    cat "$folder/logs/$program.result"
    results+=("$folder/logs/$program.result")
  done
}

results=()
for kind in "${kinds[@]}"; do
  case $kind in
    address)
      build "$kind" "-fsanitize=address,undefined -fno-sanitize-recover=all" "${every[@]}"
      run_all "$kind" "${every[@]}" ;;
    thread)
      build "$kind" -fsanitize=thread "${threaded[@]}"
      run_all "$kind" "${threaded[@]}" ;;
    *) sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}"; exit 1 ;;
  esac
done
awk '/ passed .* failed /{p += $2; f += $4} END {print p " passed, " f " failed"; exit f > 0 || !p}' "${results[@]}"
