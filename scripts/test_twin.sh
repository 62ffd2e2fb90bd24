#!/usr/bin/env bash
# Labels PyBullet's pictures of a Husky, an arm and a quadruped, from bags with TF and CameraInfo, and compares the
# masks with PyBullet's own segmentation:
#   ./scripts/test_twin.sh [FOLDER]
# Bags and datasets stay in FOLDER; without FOLDER they are removed. PyBullet is installed once, into a virtual
# environment below ~/.cache; after that no network is needed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
environment=${XDG_CACHE_HOME:-$HOME/.cache}/synthetic_dataset/twin

"$here/install_dependencies.sh" python3-venv python3-rosbag
python_environment "$environment" "$repository/test/twin/requirements.txt" /usr/bin/python3 --system-site-packages

build_workspace --target generate --target synthetic_dataset_writers
use_workspace
folder=${1:-}
if [ -z "$folder" ]; then
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
fi
PYTHONPATH=$repository/python:${PYTHONPATH:-} \
  "$environment/bin/python" "$repository/test/twin/foreign_pictures.py" "$folder"
