#!/usr/bin/env bash
# Checks that every source compiles by itself, with the oldest compiler and libraries that users have.
# By itself: without the precompiled header and outside a unity build, both of which hide a missing
# include. The oldest: GCC 9.3 and headers of Debian 11 (Eigen 3.3, OpenCV 4.5, yaml-cpp 0.6, ...),
# which are fetched from its mirror and unpacked beside the workspace. Only the syntax is checked.
#   ./scripts/check_each_source.sh [--seconds N] [FILE...]    all by default, which takes 12 minutes
# --seconds: no further source is started after this time, and the script says how many are left.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
# shellcheck source=systems.sh
source "$here/systems.sh"

packages=(
  g++-9 gcc-9 cpp-9 gcc-9-base libstdc++-9-dev libgcc-9-dev
  libeigen3-dev libgtest-dev libgmock-dev nlohmann-json3-dev libmicrohttpd-dev libegl-dev libembree-dev libyaml-cpp-dev libassimp-dev libbullet-dev
  libopencv-{core,imgproc,imgcodecs,video,calib3d,features2d,flann,dnn,contrib}-dev
)
# Names that these packages have but Ubuntu 20.04 lacks (JSON 3.9, gMock 1.11), or that OpenCV 4.10 renamed.
newer='nlohmann::ordered_json|testing::Throws|\bThrowsMessage\b|cv::float16_t'

# apt-get for Debian 11's packages, with lists and a cache of its own.
old=$systems/headers-of-bullseye
apt_of_bullseye() {
  apt-get -q -o Dir::Etc::SourceList="$old/sources.list" -o Dir::Etc::SourceParts=/dev/null \
    -o Dir::State="$old/state" -o Dir::State::status=/dev/null -o Dir::Cache="$old/cache" \
    -o Acquire::Languages=none -o APT::Sandbox::User="$(id -un)" "$@"
}
fetch_old_headers() {
  [ "$(cat "$old/complete" 2>/dev/null)" != "${packages[*]}" ] || return 0
  rm -rf "$old"
  mkdir -p "$old/state/lists/partial" "$old/cache/archives/partial" "$old/packages"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror bullseye main" \
    >"$old/sources.list"
  apt_of_bullseye update
  (cd "$old/packages" && apt_of_bullseye download "${packages[@]}")
  for package in "$old"/packages/*.deb; do dpkg-deb -x "$package" "$old/root"; done
  rm -r "$old/packages" "$old/cache" "$old/state"
  echo "${packages[*]}" >"$old/complete"
}

if grep -rnE "$newer" "$repository"/{include,src,plugins,test,benchmark,fuzz,examples} --include=*.h --include=*.cpp; then
  echo "the oldest systems do not have these"
  exit 1
fi
seconds=86400
if [ "${1:-}" = --seconds ]; then seconds=$2 && shift 2; fi
"$here/install_dependencies.sh"
fetch_old_headers
build=$workspace-each-source
mkdir -p "$build"
cmake -S "$repository" -B "$build" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-Werror \
  -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 \
  -DCATKIN_DEVEL_PREFIX="$build/devel" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
  -DSYNTHETIC_DATASET_UNITY=OFF -DSYNTHETIC_DATASET_PRECOMPILE=OFF >"$build/configure.log"
/usr/bin/python3 - "$build/compile_commands.json" "$old/root" "$seconds" "$@" <<'END'
import concurrent.futures
import json
import os
import re
import subprocess
import sys
import time

OLD = sys.argv[2]
END = time.monotonic() + float(sys.argv[3])
CHOSEN = sys.argv[4:]

with open(sys.argv[1], encoding='utf-8') as file:
    every = {entry['file']: entry for entry in json.load(file)}
chosen = set(map(os.path.realpath, CHOSEN))
# Sources that this build does not contain (examples are packages of their own) have no entry.
entries = {file: entry for file, entry in every.items() if not chosen or file in chosen}


def with_old_headers(include):
    return f'-isystem {OLD}{include[1]} ' if os.path.isdir(OLD + include[1]) else include[0]


def compiles(entry):
    """Whether a source compiles; None if there was no time to check it."""
    if time.monotonic() > END:
        return None
    command = re.sub(r'-isystem (/usr/include/\S+)', with_old_headers, entry['command'])
    command = re.sub(r'^\S+', f'{OLD}/usr/bin/g++-9', command)
    command += f' -isystem {OLD}/usr/include -fsyntax-only'
    return subprocess.run(command, shell=True, cwd=entry['directory'], check=False).returncode == 0


with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    results = dict(zip(entries, pool.map(compiles, entries.values())))
failed = [file for file, is_right in results.items() if is_right is False]
left = sum(is_right is None for is_right in results.values())
print(f'each source by itself: {len(entries) - left} sources, {len(failed)} do not compile'
      + (f'; not checked for lack of time: {left}' if left else ''))
for file in failed:
    print('  ' + file)
sys.exit(1 if failed or not (entries or chosen) else 0)
END
