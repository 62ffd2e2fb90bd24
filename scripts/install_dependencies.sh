#!/usr/bin/env bash
# Installs the packages that are missing, as root or with sudo; quick if none is.
#   ./scripts/install_dependencies.sh [MORE_PACKAGES...]
# On Debian 11 to 13, all of them are Debian's own packages, ROS 1 included. If ROS Noetic is in
# /opt/ros, as on Ubuntu 20.04, rosdep finds the packages for package.xml.
set -euo pipefail

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
export DEBIAN_FRONTEND=noninteractive
# apt does not wait for another apt that is running.
exec {lock}<"${BASH_SOURCE[0]}"
flock "$lock"

# Installs those of the given packages that are missing.
install_missing() {
  local package missing=()
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)" = "install ok installed" ] ||
      missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  echo "Installing ${#missing[@]} packages: ${missing[*]}"
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"
}

if [ -d /opt/ros/noetic ]; then
  # The last three are optional, and not in package.xml for rosdep.
  install_missing build-essential cmake pkg-config python3-rosdep libdeflate-dev libisal-dev libembree-dev "$@"
  repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
  # shellcheck disable=SC1091
  (set +u && source /opt/ros/noetic/setup.bash && rosdep check --from-paths "$repository" --ignore-src) \
    >/dev/null 2>&1 && exit 0
  [ -f /etc/ros/rosdep/sources.list.d/20-default.list ] || "${as_root[@]}" rosdep init
  rosdep update --include-eol-distros --rosdistro noetic
  "${as_root[@]}" apt-get update -q
  rosdep install --from-paths "$repository" --ignore-src --rosdistro noetic -y
  exit 0
fi

# OSMesa was removed from Mesa 25.1; with EGL, the same is drawn.
gl=libosmesa6-dev
[ -n "$(apt-cache show "$gl" 2>/dev/null)" ] || gl='libegl-dev libgl1-mesa-dri'

# Without Embree, lidars are left out; it does not exist for every processor.
[ -z "$(apt-cache show libembree-dev 2>/dev/null)" ] || gl="$gl libembree-dev"

# shellcheck disable=SC2086
install_missing \
  build-essential cmake pkg-config catkin \
  libroscpp-dev libroslib-dev librosbag-storage-dev libtf2-dev libtf2-ros-dev libtf2-msgs-dev \
  libdiagnostic-msgs-dev libgeometry-msgs-dev libnav-msgs-dev libsensor-msgs-dev libstd-msgs-dev \
  libstd-srvs-dev libvisualization-msgs-dev \
  libxmlrpcpp-dev pluginlib-dev rosbash \
  librospack-dev python3-roslaunch python3-rosbag python3-rostest librostest-dev rospack-tools \
  python3-rosservice python3-rostopic \
  python3-diagnostic-msgs python3-geometry-msgs python3-sensor-msgs python3-std-srvs python3-tf2-msgs \
  python3-visualization-msgs \
  python3-setuptools python3-numpy python3-pil python3-matplotlib python3-jinja2 ffmpeg \
  libopencv-dev libeigen3-dev libbullet-dev $gl libyaml-cpp-dev \
  libassimp-dev libfreeimage-dev libsqlite3-dev \
  libconsole-bridge-dev libtinyxml2-dev libdeflate-dev libisal-dev zlib1g-dev liblz4-dev libzstd-dev libssl-dev \
  nlohmann-json3-dev libmicrohttpd-dev libgtest-dev libgmock-dev "$@"

# Debian has no xacro. As it is used here, PyPI's newest only needs Python's YAML (src/world/files/template_file.cpp).
xacro_folder=${XDG_DATA_HOME:-$HOME/.local/share}/synthetic_dataset/xacro
if ! python3 -c 'import xacro' 2>/dev/null && [ ! -d "$xacro_folder/xacro" ]; then
  install_missing python3-pip python3-yaml
  python3 -m pip install -q --no-deps --target "$xacro_folder" xacro==2.1.1 ||
    echo "xacro could not be fetched, without which .xacro models are not read: python3 -m pip install --no-deps --target $xacro_folder xacro==2.1.1" >&2
fi
