#!/usr/bin/env bash
# Converts the example's bags to ROS 2 bags of each kind of storage and compression, makes datasets from them, and
# compares all bytes with those made from the ROS 1 bags; with --times, also how long an hour of TF takes:
#   ./scripts/test_ros2_bags.sh [--times] [FOLDER]
# Bags and datasets stay in FOLDER; without FOLDER they are removed. rosbags is installed once, into a virtual
# environment below ~/.cache; after that no network is needed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
environment=${XDG_CACHE_HOME:-$HOME/.cache}/synthetic_dataset/ros2

"$here/install_dependencies.sh" python3-venv python3-rosbag
python_environment "$environment" "$repository/test/ros2/requirements.txt" /usr/bin/python3 --system-site-packages

build_workspace --target generate --target synthetic_dataset_inspect --target synthetic_dataset_writers
use_workspace
"$environment/bin/python" "$repository/test/ros2/conversions.py" "$@"
