#!/usr/bin/env bash
# Makes a dataset of many small scenes, and fails if memory use or open file descriptors grow:
#   ./scripts/soak.sh [SCENES]
# 100,000 scenes by default.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"

"$here/install_dependencies.sh"
build_workspace --target generate synthetic_dataset_writers
use_workspace
exec /usr/bin/python3 "$repository/test/faults/soak.py" \
  "$workspace/devel/lib/synthetic_dataset" "${1:-100000}"
