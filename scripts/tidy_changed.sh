#!/usr/bin/env bash
# Runs clang-tidy on the sources of src/ and plugins/ that differ from a commit, and reports findings in lines that
# differ, in these sources and in headers that they include. Exit code 1 if there is a finding.
#   ./scripts/tidy_changed.sh [BASE [SECONDS]]
# BASE: a commit or branch; by default main, and on main itself the previous commit.
# SECONDS: no further file is started after this time, and the script says how many are left; 150 by default.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
cd "$repository"

base=$(git merge-base "${1:-main}" HEAD)
[ "$base" != "$(git rev-parse HEAD)" ] || base=$(git rev-parse HEAD~1)
# clang-tidy's --line-filter, with the lines that were added or changed; files that only moved have none.
lines=$(git diff --find-renames --unified=0 "$base" -- include src plugins | python3 -c '
import json, re, sys
files = []
for line in sys.stdin:
    if line.startswith("+++ b/"):
        files.append({"name": line[6:].strip(), "lines": []})
    added = re.match(r"@@ \S+ \+(\d+)(?:,(\d+))? @@", line)
    if added and added.group(2) != "0":
        first = int(added.group(1))
        files[-1]["lines"].append([first, first + int(added.group(2) or 1) - 1])
print(json.dumps([each for each in files if each["lines"]]))')
mapfile -t files < <(grep -oP '"name": "\K[^"]*\.cpp' <<<"$lines" || true)
echo "clang-tidy: ${#files[@]} sources differ from $(git log -1 --format='%h, %s' "$base")"
[ ${#files[@]} -gt 0 ] || exit 0

command -v clang-tidy >/dev/null || "$here/install_dependencies.sh" clang-tidy
# A separate build folder: clang reads neither GCC's precompiled headers nor the files of a unity build.
mkdir -p "$workspace-tidy"
cmake -S "$repository" -B "$workspace-tidy" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DSYNTHETIC_DATASET_UNITY=OFF \
  -DSYNTHETIC_DATASET_PRECOMPILE=OFF -DPYTHON_EXECUTABLE=/usr/bin/python3 \
  -DPython3_EXECUTABLE=/usr/bin/python3 >"$workspace-tidy/configure.log" 2>&1 ||
  { tail -20 "$workspace-tidy/configure.log"; exit 1; }
rm -f "$workspace-tidy/left"
# In a file, as the lines of a change of everything are longer than an argument may be. They contain no single quote.
printf -- "--line-filter='%s'" "$lines" >"$workspace-tidy/line_filter"
export folder=$workspace-tidy end=$((EPOCHSECONDS + ${2:-150}))
check() {  # FILE
  if ((EPOCHSECONDS > end)); then
    echo "$1" >>"$folder/left"
  else
    clang-tidy --quiet -p "$folder" @"$folder/line_filter" --warnings-as-errors='*' "$1" 2>/dev/null
  fi
}
export -f check
# shellcheck disable=SC2016
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" bash -c 'check "$1"' _
[ ! -f "$workspace-tidy/left" ] ||
  echo "clang-tidy: not checked for lack of time: $(wc -l <"$workspace-tidy/left") sources"
echo "clang-tidy: no finding in what was checked"
