#!/usr/bin/env bash
# Measures how fast scenes are made, beside MuJoCo, PyBullet, pyrender and a bare OpenGL program on
# the same scene, and what a dataset costs besides:
#   ./scripts/benchmark.sh [RESULTS [ARGUMENTS...]]
# RESULTS (./benchmark_results by default) gets table.md, results.json, plot.png, costs.md, costs.json,
# cameras.md and cameras.json; ARGUMENTS are those of benchmark/speed/run.py. What it is compared with is installed
# once, from PyPI, into a virtual environment below ~/.cache. All of it takes about three quarters of
# an hour on two cores.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
environment=${XDG_CACHE_HOME:-$HOME/.cache}/synthetic_dataset/rivals
requirements=$repository/benchmark/speed/requirements.txt

"$here/install_dependencies.sh" python3-venv python3-rosbag python3-tf2-msgs python3-geometry-msgs
if ! cmp -s "$requirements" "$environment/complete"; then
  rm -rf "$environment"
  /usr/bin/python3 -m venv --system-site-packages "$environment"
  # pyrender asks for a PyOpenGL that has no OSMesa contexts, hence without dependencies.
  "$environment/bin/pip" --disable-pip-version-check install -q -I --no-deps -r "$requirements"
  cp "$requirements" "$environment/complete"
fi

build_workspace --target generate synthetic_dataset_writers benchmark_floor
use_workspace
results=${1:-benchmark_results}
shift || true
programs=$workspace/devel/lib
"$environment/bin/python" "$repository/benchmark/speed/run.py" "$programs" "$results" "$@"
"$environment/bin/python" "$repository/benchmark/speed/costs.py" "$programs/synthetic_dataset/generate" "$results"
/usr/bin/python3 "$repository/benchmark/speed/cameras.py" "$programs/synthetic_dataset/generate" "$results"
