#!/usr/bin/env bash
# Opens preview.launch with a real RViz, on a virtual display, and looks at the screen:
#   ./scripts/test_preview.sh [FOLDER]
# The screenshots stay in FOLDER; without FOLDER they are removed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"

"$here/install_dependencies.sh" rviz xvfb imagemagick python3-opencv
build_workspace --target preview --target synthetic_dataset_writers
use_workspace
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
folder=${1:-$scratch}
mkdir -p "$folder"
# A ROS master of its own, so that no other one interferes.
export ROS_MASTER_URI=http://localhost:11398
/usr/bin/python3 "$repository/test/preview/rviz_test.py" "$(cd "$folder" && pwd)"
