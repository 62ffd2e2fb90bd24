#!/usr/bin/env bash
# Runs the unit tests under clang's sanitizers; exit code 0 only if all pass and nothing is reported.
#   ./scripts/sanitize.sh [address|thread|all] [--seconds N] [PROGRAM...]
# address: every test program, or only those named ("test_motion"), under AddressSanitizer (with leaks) and
#   UndefinedBehaviorSanitizer.
# thread:  the programs that use threads, under ThreadSanitizer.
# --seconds: no further program is built after this time, and the script says which are left.
# The builds and each program's log are beside the workspace (scripts/workspace.sh). sanitizers/*.txt list
# known reports about third-party libraries, which are not faults of this code.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
kinds=("${1:-all}")
[ "${kinds[0]}" != all ] || kinds=(address thread)
shift || true
end=
if [ "${1:-}" = --seconds ]; then end=$((SECONDS + $2)) && shift 2; fi

# The test programs that use threads; to be extended when other code uses threads.
threaded=(test_output)
# Comparisons by brute force run the same code as other tests, and would take half of the time. If time is limited, whole
# runs are left out as well, and tests over many lenses run only with a polynomial one and a fisheye.
long_tests=$(cat "$repository/test/long_tests.txt")
if [ -n "$end" ]; then
  long_tests+=$(printf '\n*/%s' rational tilted_prism omnidirectional double_sphere fisheye_170 narrow_fisheye wide_plumb_bob)
else
  long_tests=$(sed '/^# Whole runs/,$d' <<<"$long_tests")
fi
GTEST_FILTER="-$(grep -E '^[^#]*[.*]' <<<"$long_tests" | paste -sd:)"
export GTEST_FILTER
# In the order of the rooms: a program links the libraries of those before it, which are then built already.
mapfile -t every < <(grep -oP '^add_subdirectory\(\K\w+' "$repository/test/CMakeLists.txt" | while read -r room; do
  grep -qs 'synthetic_dataset_test(' "$repository/test/$room/CMakeLists.txt" && echo "test_$room"; done)
if [ $# -gt 0 ]; then
  mapfile -t every < <(printf '%s\n' "${every[@]}" | grep -xF "$(printf '%s\n' "$@")")
fi

"$here/install_dependencies.sh" clang libclang-rt-14-dev llvm-14
# A user's own values of these must not change the result.
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

configure() {  # KIND FLAGS
  local folder kind=$1 flags="-O1 -gline-tables-only -fno-omit-frame-pointer -D_GLIBCXX_ASSERTIONS $2"
  folder=$(folder_of "$kind")
  mkdir -p "$folder/logs"
  cmake -S "$repository" -B "$folder/build" -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
    -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$flags" -DPYTHON_EXECUTABLE=/usr/bin/python3 \
    -DPython3_EXECUTABLE=/usr/bin/python3 >"$folder/logs/configure.log" 2>&1 ||
    { tail -20 "$folder/logs/configure.log"; exit 1; }
}

# Runs a program in as many parts as there are cores; prints one line, and part of the log if something is wrong.
run() {  # FOLDER PROGRAM
  local log=$1/logs/$2.log start=$SECONDS status=0 passed failed scratch parts=() part
  scratch=$(mktemp -d)
  for ((part = 0; part < $(nproc); ++part)); do
    mkdir "$scratch/$part"
    (cd "$repository/test" && TMPDIR=$scratch/$part GTEST_TOTAL_SHARDS=$(nproc) GTEST_SHARD_INDEX=$part LP_NUM_THREADS=1 \
      "$1/build/devel/lib/synthetic_dataset_tests/$2") >"$scratch/$part.log" 2>&1 &
    parts+=($!)
  done
  for part in "${parts[@]}"; do wait "$part" || status=$?; done
  cat "$scratch"/*.log >"$log"
  rm -rf "$scratch"
  passed=$(grep -c '^\[       OK \]' "$log" || true)
  failed=$(grep -c '^\[  FAILED  \] .* ms)$' "$log" || true)
  [ "$status" -eq 0 ] || [ "$failed" -gt 0 ] || failed=1  # it crashed, or something was reported at its end
  printf '%-22s %5s passed %3s failed %5s s\n' "$2" "$passed" "$failed" $((SECONDS - start))
  [ "$failed" -gt 0 ] || return 0
  grep -E -m 3 -A 25 ': Failure$|ERROR: |WARNING: |runtime error: ' "$log" || tail -5 "$log"
  echo "  see $log"
}

# Runs each program while the next one is built.
run_all() {  # KIND PROGRAMS...
  local folder program done=()
  folder=$(folder_of "$1")
  echo "== $1"
  for program in "${@:2}"; do
    if [ -n "$end" ] && [ "$SECONDS" -ge "$end" ]; then
      echo "not run for lack of time: $program"
      continue
    fi
    cmake --build "$folder/build" --parallel "$(nproc)" --target "$program" >"$folder/logs/$program.build" 2>&1 ||
      { tail -40 "$folder/logs/$program.build"; exit 1; }
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n; done
    run "$folder" "$program" >"$folder/logs/$program.result" &
    done+=("$program")
  done
  wait
  for program in "${done[@]}"; do
    cat "$folder/logs/$program.result"
    results+=("$folder/logs/$program.result")
  done
}

results=()
for kind in "${kinds[@]}"; do
  case $kind in
    address)
      configure "$kind" "-fsanitize=address,undefined -fno-sanitize-recover=all"
      run_all "$kind" "${every[@]}" ;;
    thread)
      configure "$kind" -fsanitize=thread
      run_all "$kind" "${threaded[@]}" ;;
    *) sed -n '2,9s/^# //p' "${BASH_SOURCE[0]}"; exit 1 ;;
  esac
done
awk '/ passed .* failed /{p += $2; f += $4} END {print p " passed, " f " failed"; exit f > 0 || !p}' "${results[@]}"
