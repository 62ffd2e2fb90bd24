#!/usr/bin/env bash
# Makes the reference of the public API with Doxygen; exit code 1 if Doxygen warns.
#   ./scripts/api_docs.sh [FOLDER]     build/api_docs by default
set -euo pipefail
folder=$(realpath -m "${1:-$(dirname "${BASH_SOURCE[0]}")/../build/api_docs}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."

command -v doxygen >/dev/null || ./scripts/install_dependencies.sh doxygen
version=$(grep -oP 'project\(synthetic_dataset VERSION \K[\d.]+' CMakeLists.txt)
mkdir -p "$folder"
{ cat docs/Doxyfile; echo "PROJECT_NUMBER = $version"; echo "OUTPUT_DIRECTORY = \"$folder\""; } | doxygen -
echo "$folder/html/index.html"
