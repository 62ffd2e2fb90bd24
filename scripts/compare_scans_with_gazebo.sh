#!/usr/bin/env bash
# Scans worlds of the reference data with this program's lidars, and holds each ray against Gazebo 11's own sensors, whose
# scans are in test/reference/gazebo_scans (scripts/gazebo_scans/record.py makes them anew):
#   ./scripts/compare_scans_with_gazebo.sh REFERENCE_FOLDER [OUTPUT_FOLDER]
# Fails where less than 99 % of the rays agree (but ENOUGH_IN in compare.py). The output folder gets the runs, and a table.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
reference=$(realpath "$1")
output=$(realpath -m "${2:-$(mktemp -d)}")

build_workspace --target generate synthetic_dataset_writers
use_workspace
python3 "$here/gazebo_scans/compare.py" "$reference" "$output"
