#!/usr/bin/env bash
# Checks that the C++ files are formatted as .clang-format says; changes nothing. Exit code 1 if one is not.
#   ./scripts/check_format.sh [FILES...]     all files by default
# The judge is clang-format 14, Debian 12's. To format files: clang-format -i FILES
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

command -v clang-format >/dev/null || ./scripts/install_dependencies.sh clang-format
files=("$@")
[ $# -gt 0 ] || mapfile -t files < <(
  find include src plugins test fuzz benchmark examples cmake -name '*.h' -o -name '*.cpp')
clang-format --dry-run -Werror "${files[@]}"
echo "format: ${#files[@]} files are right"
