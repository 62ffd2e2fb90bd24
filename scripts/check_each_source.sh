#!/usr/bin/env bash
# Checks that every source compiles by itself: without the precompiled header, and not as one with
# others, both of which hide a missing include. Only the syntax is checked, so it takes some minutes.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"

"$here/install_dependencies.sh"
build=$workspace-each-source
mkdir -p "$build"
cmake -S "$repository" -B "$build" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-Werror \
  -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 \
  -DCATKIN_DEVEL_PREFIX="$build/devel" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
  -DSYNTHETIC_DATASET_UNITY=OFF -DSYNTHETIC_DATASET_PRECOMPILE=OFF >"$build/configure.log"
/usr/bin/python3 - "$build/compile_commands.json" <<'END'
import concurrent.futures
import json
import os
import subprocess
import sys

with open(sys.argv[1], encoding='utf-8') as file:
    entries = {entry['file']: entry for entry in json.load(file)}


def compiles(entry):
    return subprocess.run(entry['command'] + ' -fsyntax-only', shell=True, cwd=entry['directory'],
                          check=False).returncode == 0


with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    failed = [file for file, is_right in zip(entries, pool.map(compiles, entries.values()))
              if not is_right]
print(f'each source by itself: {len(entries)} sources, {len(failed)} do not compile')
for file in failed:
    print('  ' + file)
sys.exit(1 if failed or not entries else 0)
END
