#!/usr/bin/env bash
# Checks that C++ and JavaScript files are formatted as the nearest .clang-format says, and JavaScript for mistakes;
# changes nothing. Exit code 1 if there is something to fix.
#   ./scripts/check_format.sh [FILES...]     all files by default
# Uses clang-format 14, Debian 12's, and oxlint. To format files: clang-format -i FILES
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

command -v clang-format >/dev/null || ./scripts/install_dependencies.sh clang-format
files=("$@")
[ $# -gt 0 ] || mapfile -t files < <(
  find include src plugins test fuzz benchmark examples cmake -name '*.h' -o -name '*.cpp' -o -name '*.js')
clang-format --dry-run -Werror "${files[@]}"
echo "format: ${#files[@]} files are right"

mapfile -t scripts < <(printf '%s\n' "${files[@]}" | grep '\.js$' || true)
[ ${#scripts[@]} -gt 0 ] || exit 0
oxlint=1.89.0
environment=${XDG_CACHE_HOME:-$HOME/.cache}/synthetic_dataset/oxlint-$oxlint
if [ ! -x "$environment/bin/oxlint" ]; then
  ./scripts/install_dependencies.sh python3-venv
  /usr/bin/python3 -m venv "$environment"
  "$environment/bin/pip" --disable-pip-version-check install -q --no-deps "oxlint==$oxlint"
fi
# approx-constant: the ends of sliders are rounded, such as 3.1416.
"$environment/bin/oxlint" --deny correctness --allow approx-constant "${scripts[@]}"
