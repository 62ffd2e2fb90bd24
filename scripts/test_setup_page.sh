#!/usr/bin/env bash
# Uses the page of setup_assistant in headless Chromium as a user does:
#   ./scripts/test_setup_page.sh [FOLDER]
# Screenshots of all panes stay in FOLDER; without FOLDER they are removed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"

"$here/install_dependencies.sh" chromium chromium-driver python3-selenium fonts-dejavu-core
build_workspace --target setup_assistant --target generate --target synthetic_dataset_writers
use_workspace
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
folder=${1:-$scratch/screenshots}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
cd "$repository/test/setup_assistant"
for test in page whole_way big_bag; do
  /usr/bin/python3 "${test}_test.py" "$folder"
done
