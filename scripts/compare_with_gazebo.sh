#!/usr/bin/env bash
# Draws the worlds for which the reference data has Gazebo's own pictures, and compares ours with them:
#   ./scripts/compare_with_gazebo.sh REFERENCE_FOLDER [OUTPUT_FOLDER]
# Fails if a world of test/reference/agreeing_worlds.txt no longer agrees. The pictures, side by side, and a
# table go to the output folder.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
reference=$(realpath "$1")
output=$(realpath -m "${2:-$(mktemp -d)}")
kept=$repository/test/reference/agreeing_worlds.txt

"$here/install_dependencies.sh" python3-opencv
build_workspace --target generate synthetic_dataset_writers
use_workspace
# Does not use Gazebo's media, so that the result does not depend on whether Gazebo is installed, unless
# GAZEBO_MEDIA names its share folder (share/gazebo-11).
python3 "$here/compare_with_gazebo.py" "$reference" "$output" --media "${GAZEBO_MEDIA:-/nowhere}" | tee "$output.log"
mkdir -p "$output" && mv "$output.log" "$output/log.txt"

grep '^agrees' "$output/table.txt" | awk '{print $2}' | sort >"$output/agreeing_worlds.txt"
if lost=$(comm -23 <(sort "$kept") "$output/agreeing_worlds.txt") && [ -n "$lost" ]; then
  printf 'these agreed with Gazebo before, and do not any more (pictures: %s):\n%s\n' "$output" "$lost"
  exit 1
fi
echo "worlds that agree with Gazebo: $(wc -l <"$output/agreeing_worlds.txt"), kept: $(wc -l <"$kept")"
