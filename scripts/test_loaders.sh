#!/usr/bin/env bash
# Loads datasets of every format with the formats' own loaders and compares them with the ground truth, reads ROS 2
# bags, and runs the programs in docs/python.md:
#   ./scripts/test_loaders.sh [FOLDER [FORMAT...]]
# The datasets stay in FOLDER; without FOLDER they are removed. OPENPCDET names a clone of OpenPCDet, if its own
# data preparation is to run. The loaders are installed once, into a
# virtual environment below ~/.cache; after that no network is needed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
environments=${XDG_CACHE_HOME:-$HOME/.cache}/synthetic_dataset

"$here/install_dependencies.sh" python3-venv python3-yaml python3-opencv python3-torch \
  python3-torchvision
requirements=$repository/test/loaders
python_environment "$environments/loaders" "$requirements/requirements.txt" /usr/bin/python3 --system-site-packages
python_environment "$environments/fiftyone" "$requirements/requirements_fiftyone.txt"
export SYNTHETIC_DATASET_FIFTYONE_PYTHON=$environments/fiftyone/bin/python

build_workspace --target make_loader_datasets --target generate --target synthetic_dataset_writers
use_workspace
folder=${1:-}
shift || true
if [ -z "$folder" ]; then
  folder=$(mktemp -d)
  trap 'rm -rf "$folder"' EXIT
fi
"$workspace/devel/lib/synthetic_dataset_tests/make_loader_datasets" "$folder"
"$environments/loaders/bin/python" "$repository/test/loaders/run.py" "$folder" "$@"
