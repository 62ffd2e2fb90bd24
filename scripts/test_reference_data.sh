#!/usr/bin/env bash
# Checks label files, masks and recordings against reference data outside the repository:
#   ./scripts/test_reference_data.sh FOLDER
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
SYNTHETIC_DATASET_REFERENCE=$(realpath "$1")
export SYNTHETIC_DATASET_REFERENCE

# A second opinion on worlds, if it is packaged.
if apt-cache show libsdformat-dev >/dev/null 2>&1; then
  "$here/install_dependencies.sh" libsdformat-dev
  [ ! -d "$workspace/build" ] || flock "$workspace" cmake "$workspace/build" >/dev/null
fi
build_workspace --target test_reference_data test_reference_worlds test_sdformat_oracle
use_workspace
"$workspace/devel/lib/synthetic_dataset_tests/test_reference_data"
"$workspace/devel/lib/synthetic_dataset_tests/test_reference_worlds"
oracle=$workspace/devel/lib/synthetic_dataset_tests/test_sdformat_oracle
[ ! -x "$oracle" ] || "$oracle"
