#!/usr/bin/env bash
# Measures how fast scenes are made, compared with MuJoCo, PyBullet, pyrender, BlenderProc (if there is a
# Python 3.11, which Blender needs) and a bare OpenGL program on the same scene, and the other costs of a dataset:
#   ./scripts/benchmark.sh [RESULTS [ARGUMENTS...]]
# RESULTS (./benchmark_results by default) gets table.md, results.json, plot.png, costs.md, costs.json,
# cameras.md and cameras.json; ARGUMENTS are those of benchmark/speed/run.py. The other programs are installed
# once, from PyPI, into virtual environments below ~/.cache. Everything takes about three quarters of
# an hour on two cores.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
environments=${XDG_CACHE_HOME:-$HOME/.cache}/synthetic_dataset
speed=$repository/benchmark/speed

"$here/install_dependencies.sh" python3-venv python3-rosbag python3-tf2-msgs python3-geometry-msgs
python_environment "$environments/rivals" "$speed/requirements.txt" /usr/bin/python3 --system-site-packages
blenderproc=()
if [ -x /usr/bin/python3.11 ]; then
  python_environment "$environments/blenderproc" "$speed/blenderproc_requirements.txt" /usr/bin/python3.11
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
