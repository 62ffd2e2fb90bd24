# Sourced by the other scripts: where the repository and its catkin workspace are, and how to build it.

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# Outside the sources: roslaunch and rosrun search a package's folder including its symbolic links, and
# would find everything twice. Each clone has its own workspace.
workspace=${SYNTHETIC_DATASET_WORKSPACE:-${XDG_CACHE_HOME:-$HOME/.cache}/synthetic_dataset/workspace-$(printf '%s' "$repository" | cksum | cut -d' ' -f1)}

# ROS's tools are those of the distribution; a different Python first on PATH would not find their modules.
export PATH="/usr/bin:/bin:$PATH"

# Ubuntu's ROS is in a folder of its own, unlike Debian's.
if [ -f /opt/ros/noetic/setup.bash ]; then
  set +u  # catkin's file reads variables that may be unset
  # shellcheck disable=SC1091
  source /opt/ros/noetic/setup.bash
  set -u
fi

# build_workspace [CMake build arguments...]: configures the workspace if needed and builds it, one script at a time.
build_workspace() (
  mkdir -p "$workspace/src"
  exec {lock}<"$workspace"
  flock "$lock"
  ln -sfn "$repository" "$workspace/src/synthetic_dataset"
  [ -f "$workspace/.catkin_workspace_ready" ] || {
    (cd "$workspace" && catkin_make --cmake-args -DCMAKE_BUILD_TYPE=RelWithDebInfo \
      -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 \
      -DCMAKE_EXPORT_COMPILE_COMMANDS=ON --make-args cmake_check_build_system) &&
      touch "$workspace/.catkin_workspace_ready"
  } || return
  cmake --build "$workspace/build" --parallel "$(build_jobs)" "$@"
)

# As many compilers as there are cores, and memory for: sixteen sources compiled as one take up to 1.7 GB.
build_jobs() {
  local memory
  memory=$(awk '/^MemAvailable:/ {print int($2 / 1700000)}' /proc/meminfo)
  [ "$memory" -ge 1 ] || memory=1
  echo $((memory < $(nproc) ? memory : $(nproc)))
}

# python_environment FOLDER REQUIREMENTS [PYTHON [OPTIONS OF venv...]]: installs a list of packages into a virtual
# environment, once and again when the list changes. --no-deps: the lists include all dependencies; -I: installs
# packages even if the system has another version.
python_environment() {
  local folder=$1 requirements=$2 python=${3:-/usr/bin/python3}
  cmp -s "$requirements" "$folder/complete" && return
  rm -rf "$folder"
  "$python" -m venv "${@:4}" "$folder"
  "$folder/bin/pip" --disable-pip-version-check install -q -I --no-deps -r "$requirements"
  cp "$requirements" "$folder/complete"
}

use_workspace() {
  set +u  # catkin's file reads variables that may be unset
  # shellcheck disable=SC1091
  source "$workspace/devel/setup.bash"
  set -u
}
