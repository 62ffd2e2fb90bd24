#!/usr/bin/env bash
# Measures how fast scenes are made, beside MuJoCo, PyBullet, pyrender, BlenderProc (where there is a
# Python 3.11, which Blender wants) and a bare OpenGL program on the same scene, and what a dataset costs besides:
#   ./scripts/benchmark.sh [RESULTS [ARGUMENTS...]]
# RESULTS (./benchmark_results by default) gets table.md, results.json, plot.png, costs.md, costs.json,
# cameras.md and cameras.json; ARGUMENTS are those of benchmark/speed/run.py. What it is compared with is installed
# once, from PyPI, into a virtual environment below ~/.cache. All of it takes about three quarters of
# an hour on two cores.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
environments=${XDG_CACHE_HOME:-$HOME/.cache}/synthetic_dataset
speed=$repository/benchmark/speed

# Installs a list of packages once. Without what they depend on, which the lists have: pyrender asks for a PyOpenGL
# that has no OSMesa contexts.
make_environment() {
  local environment=$1 python=$2 requirements=$3
  if ! cmp -s "$requirements" "$environment/complete"; then
    rm -rf "$environment"
    "$python" -m venv "${@:4}" "$environment"
    "$environment/bin/pip" --disable-pip-version-check install -q -I --no-deps -r "$requirements"
    cp "$requirements" "$environment/complete"
  fi
}

"$here/install_dependencies.sh" python3-venv python3-rosbag python3-tf2-msgs python3-geometry-msgs
make_environment "$environments/rivals" /usr/bin/python3 "$speed/requirements.txt" --system-site-packages
blenderproc=()
if [ -x /usr/bin/python3.11 ]; then
  make_environment "$environments/blenderproc" /usr/bin/python3.11 "$speed/blenderproc_requirements.txt"
  blenderproc=(--blenderproc "$environments/blenderproc/bin/python")
fi

build_workspace --target generate synthetic_dataset_writers benchmark_floor
use_workspace
results=${1:-benchmark_results}
shift || true
programs=$workspace/devel/lib
python=$environments/rivals/bin/python
"$python" "$speed/run.py" "$programs" "$results" ${blenderproc[@]+"${blenderproc[@]}"} "$@"
"$python" "$speed/costs.py" "$programs/synthetic_dataset/generate" "$results"
/usr/bin/python3 "$speed/cameras.py" "$programs/synthetic_dataset/generate" "$results"
