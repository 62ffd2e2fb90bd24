#!/usr/bin/env bash
# Provokes faults in the program `generate`, and compares the result with that of an unbroken run:
#   ./scripts/test_faults.sh [--trials PERCENT] [--seed SEED] [--write-table] [FAMILY...]
# --trials: how many, in per cent of the usual number. --seed: other moments and inputs. --write-table: puts the results into
# docs/reliability.md. A family is a file of test/faults. Disks are mounted where no other process sees
# them: as root, or in a user namespace.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"

"$here/install_dependencies.sh" strace util-linux
build_workspace --target generate merge synthetic_dataset_writers
use_workspace
arguments=()
for argument in "$@"; do
  arguments+=("$argument")
  [ "$argument" != --write-table ] || arguments+=("$repository/docs/reliability.md")
done
mounts_of_its_own=()
if unshare --mount true 2>/dev/null; then
  mounts_of_its_own=(unshare --mount)
elif unshare --map-root-user --mount true 2>/dev/null; then
  mounts_of_its_own=(unshare --map-root-user --mount)
fi
exec "${mounts_of_its_own[@]}" /usr/bin/python3 "$repository/test/faults/run.py" \
  "$workspace/devel/lib/synthetic_dataset" "${arguments[@]}"
