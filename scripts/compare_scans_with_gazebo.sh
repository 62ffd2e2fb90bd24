#!/usr/bin/env bash
# Scans worlds of the reference data with this program's lidars, and compares each ray with Gazebo 11's own sensors, whose
# scans are in test/reference/gazebo_scans (scripts/gazebo_scans/record.py makes them again):
#   ./scripts/compare_scans_with_gazebo.sh REFERENCE_FOLDER [OUTPUT_FOLDER]
# Fails if less than 99 % of a world's rays agree (but see ENOUGH_IN in compare.py). Runs and a table go to OUTPUT_FOLDER.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
reference=$(realpath "$1")
output=$(realpath -m "${2:-$(mktemp -d)}")

build_workspace --target generate synthetic_dataset_writers
use_workspace
python3 "$here/gazebo_scans/compare.py" "$reference" "$output"
