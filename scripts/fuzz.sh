#!/usr/bin/env bash
# Fuzzes each reader of files for a while with clang's libFuzzer, AddressSanitizer and
# UndefinedBehaviorSanitizer; exit code 0 only if nothing crashes, hangs or takes too much memory.
#   [FUZZ_SEED=N] ./scripts/fuzz.sh [SECONDS_EACH [TARGET...]]     60 seconds and all targets of fuzz/ by default
# All results are beside the workspace (scripts/workspace.sh), outside the sources: the build, the
# interesting inputs that were found (with which the next call starts) and, in `crashes`, the inputs
# that broke something; the table at the end says how to run one again.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
seconds=${1:-60}
shift || true

"$here/install_dependencies.sh" clang libclang-rt-14-dev
folder=$workspace-fuzzing
mkdir -p "$folder/logs" "$folder/crashes"
cmake -S "$repository" -B "$folder/build" -DSYNTHETIC_DATASET_FUZZ=ON -DCATKIN_ENABLE_TESTING=OFF \
  -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=None \
  -DCMAKE_CXX_FLAGS="-O1 -g1" -DPYTHON_EXECUTABLE=/usr/bin/python3 \
  -DPython3_EXECUTABLE=/usr/bin/python3 >"$folder/logs/configure.log" 2>&1 ||
  { tail -20 "$folder/logs/configure.log"; exit 1; }
cmake --build "$folder/build" --parallel "$(nproc)" --target fuzzers
programs=$(dirname "$(find "$folder/build" -name config_fuzz -type f -perm -u+x | head -1)")

targets=("$@")
[ ${#targets[@]} -gt 0 ] ||
  mapfile -t targets < <(find "$repository/fuzz" -name '*_fuzz.cpp' -printf '%f\n' | sort | sed 's/_fuzz.cpp//')
seeds=$folder/seeds
"$programs/make_seeds" "$seeds"

# A child process with a fault exits with 99, by which the parent recognises it (fuzz/fuzzing.cpp).
export ASAN_OPTIONS=exitcode=99:detect_leaks=0:allocator_may_return_null=0
export UBSAN_OPTIONS=exitcode=99:print_stacktrace=1
# A user's own values of these must not change the result.
unset GAZEBO_MODEL_PATH GZ_SIM_RESOURCE_PATH IGN_GAZEBO_RESOURCE_PATH SDF_PATH GAZEBO_RESOURCE_PATH

fuzz() {  # TARGET
  local found=$folder/found/$1 inputs=()
  mkdir -p "$found"
  for inputs_of in "$seeds/$1" "$repository/fuzz/corpus/$1"; do
    [ ! -d "$inputs_of" ] || inputs+=("$inputs_of")
  done
  # A fuzzer that runs out of memory does not always end by itself.
  timeout --kill-after=10 $((seconds + 120)) "$programs/$1_fuzz" -seed="${FUZZ_SEED:-1}" -max_total_time="$seconds" \
    -timeout=25 -report_slow_units=25 -rss_limit_mb=2048 -malloc_limit_mb=2048 \
    -max_len=20000 -print_final_stats=1 -verbosity=1 \
    -artifact_prefix="$folder/crashes/$1-" "$found" "${inputs[@]}" \
    >"$folder/logs/$1.log" 2>&1 || true
}

for target in "${targets[@]}"; do
  rm -f "$folder/crashes/$target-"* "$folder/logs/$target.log"
  while [ "$(jobs -rp | wc -l)" -ge 2 ]; do wait -n; done
  echo "Fuzzing $target for $seconds s"
  fuzz "$target" &
done
wait

failed=0
printf '\n%-14s %12s %8s\n' target executions crashes
for target in "${targets[@]}"; do
  log=$folder/logs/$target.log
  executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -1)
  crashes=$(find "$folder/crashes" -name "$target-*" | wc -l)
  printf '%-14s %12s %8s\n' "$target" "${executions:--}" "$crashes"
  # If its last lines are missing, a fuzzer has ended early, even if it left no input.
  if [ "$crashes" -gt 0 ] || [ -z "$executions" ]; then
    failed=1
    echo "  see $log"
    find "$folder/crashes" -name "$target-*" -printf "  again: ASAN_OPTIONS=$ASAN_OPTIONS $programs/${target}_fuzz %p\n"
  fi
done
exit $failed
