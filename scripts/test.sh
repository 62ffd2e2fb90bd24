#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test; exit code 0 only if all pass.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"

"$here/install_dependencies.sh"
"$here/check_layers.py"
build_workspace
build_workspace --target tests
"$here/check_symbols.py" "$workspace/build"
use_workspace
rm -rf "$workspace/build/test_results"
cmake --build "$workspace/build" --target run_tests
"$here/test_results.py" "$workspace/build/test_results"
