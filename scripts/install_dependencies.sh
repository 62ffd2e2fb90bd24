#!/usr/bin/env bash
# Installs what is missing of Debian's packages; quick when nothing is. As root, or with sudo.
#   ./scripts/install_dependencies.sh [MORE_PACKAGES...]
set -euo pipefail

packages=(
  build-essential cmake pkg-config catkin
  libroscpp-dev libroslib-dev librosbag-storage-dev libtf2-dev libtf2-ros-dev libtf2-msgs-dev
  libgeometry-msgs-dev libnav-msgs-dev libsensor-msgs-dev libstd-msgs-dev libvisualization-msgs-dev
  libxmlrpcpp-dev pluginlib-dev rosbash
  librospack-dev python3-roslaunch python3-rosbag python3-rostest librostest-dev rospack-tools
  python3-geometry-msgs python3-tf2-msgs
  python3-setuptools python3-numpy python3-pil python3-matplotlib python3-jinja2 ffmpeg
  libopencv-dev libeigen3-dev libbullet-dev libosmesa6-dev libyaml-cpp-dev
  libassimp-dev libfreeimage-dev liburdfdom-dev libsqlite3-dev
  libconsole-bridge-dev libtinyxml2-dev libdeflate-dev libisal-dev zlib1g-dev libssl-dev nlohmann-json3-dev
  libgtest-dev libgmock-dev
)
packages+=("$@")

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
  [ "$status" = "install ok installed" ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

echo "Installing ${#missing[@]} packages: ${missing[*]}"
as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -q
"${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"
