#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests; exit code 0 only if all pass.
#   ./scripts/test.sh [--all]
# Without --all, long tests are left out (test/long_tests.txt): comparisons by brute force, most runs of whole
# programs. CONTRIBUTING.md names the tests that need more than this script installs.
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
"$here/run_tests.py" "$workspace" "$@"
