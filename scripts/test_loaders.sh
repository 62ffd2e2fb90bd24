#!/usr/bin/env bash
# Loads datasets of every format with the formats' own loaders and compares with the truth, and converts bags of ROS 2:
#   ./scripts/test_loaders.sh [FOLDER [FORMAT...]]
# FOLDER keeps the datasets; without it they are removed. The loaders are installed once, into a
# virtual environment below ~/.cache; after that no network is needed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
environment=${XDG_CACHE_HOME:-$HOME/.cache}/synthetic_dataset/loaders
requirements=$repository/test/loaders/requirements.txt

"$here/install_dependencies.sh" python3-venv python3-numpy python3-pil python3-yaml python3-opencv \
  python3-torch python3-torchvision
if ! cmp -s "$requirements" "$environment/complete"; then
  rm -rf "$environment"
  /usr/bin/python3 -m venv --system-site-packages "$environment"
  # -I: also what Debian has in another version.
  "$environment/bin/pip" --disable-pip-version-check install -q -I --no-deps -r "$requirements"
  cp "$requirements" "$environment/complete"
fi

build_workspace --target make_loader_datasets generate
use_workspace
folder=${1:-}
shift || true
if [ -z "$folder" ]; then
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
fi
"$workspace/devel/lib/synthetic_dataset_tests/make_loader_datasets" "$folder"
"$environment/bin/python" "$repository/test/loaders/run.py" "$folder" "$@"
