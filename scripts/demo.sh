#!/usr/bin/env bash
# Installs what is missing, builds, and makes the bundled example's dataset with roslaunch.
#   ./scripts/demo.sh [OUTPUT_FOLDER]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
output=$(realpath -m "${1:-$repository/datasets/example}")

"$here/install_dependencies.sh"
build_workspace
use_workspace
roslaunch synthetic_dataset generate.launch \
  config:="$repository/config/example.yaml" output_folder:="$output" if_exists:=overwrite

# roslaunch exits with 0 whatever its node returned: the manifest says whether the run is complete.
"$here/describe_dataset.py" "$output"
rosrun synthetic_dataset draw_labels "$output" "$output/overview.png"
echo "Labels drawn into one of its scenes: $output/overview.png"
echo "To use the package from a shell: source $workspace/devel/setup.bash"
