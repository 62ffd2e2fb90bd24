#!/usr/bin/env bash
# Makes the report of the dataset of config/example_motions.yaml and tests it in headless Chromium:
#   ./scripts/test_report.sh [FOLDER]
# The page and its screenshots stay in FOLDER; without FOLDER they are removed.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"

"$here/install_dependencies.sh" chromium fonts-dejavu-core
build_workspace --target generate --target synthetic_dataset_writers
use_workspace
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
folder=${1:-$scratch/page}
mkdir -p "$folder"
rosrun synthetic_dataset generate --config "$repository/config/example_motions.yaml" \
  output_folder:="$scratch/dataset" > "$scratch/generate.log"
rosrun synthetic_dataset report "$scratch/dataset" "$folder/report.html"
/usr/bin/python3 "$repository/test/browser/page_in_browser_test.py" "$folder/report.html" "$folder"
