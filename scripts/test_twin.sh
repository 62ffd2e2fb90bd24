#!/usr/bin/env bash
# Labels pictures of a Husky, an arm and a quadruped that PyBullet has drawn, from bags with TF and CameraInfo, and
# compares the masks with PyBullet's own segmentation:
#   ./scripts/test_twin.sh [FOLDER]
# FOLDER keeps bags and datasets; without it they are removed. PyBullet is installed once, into a virtual
# environment below ~/.cache; after that no network is needed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
environment=${XDG_CACHE_HOME:-$HOME/.cache}/synthetic_dataset/twin
requirements=$repository/test/twin/requirements.txt

"$here/install_dependencies.sh" python3-venv python3-rosbag
if ! cmp -s "$requirements" "$environment/complete"; then
  rm -rf "$environment"
  /usr/bin/python3 -m venv --system-site-packages "$environment"
  "$environment/bin/pip" --disable-pip-version-check install -q --no-deps -r "$requirements"
  cp "$requirements" "$environment/complete"
fi

build_workspace --target generate --target synthetic_dataset_writers
use_workspace
folder=${1:-}
if [ -z "$folder" ]; then
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
fi
PYTHONPATH=$repository/python:${PYTHONPATH:-} \
  "$environment/bin/python" "$repository/test/twin/foreign_pictures.py" "$folder"
