#!/usr/bin/env bash
# Builds everything and installs it into a folder that needs neither the sources nor a compiler:
#   ./scripts/make_install_space.sh FOLDER
# On another machine with the same release of Debian or Ubuntu, the folder has to be at the same
# path, and the packages listed in FOLDER/packages.txt have to be installed. Then
#   FOLDER/env.sh FOLDER/lib/synthetic_dataset/generate --config settings.yaml
# makes a dataset.
set -euo pipefail
[ $# -eq 1 ] || { echo "usage: $0 FOLDER" >&2; exit 2; }
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
folder=$(realpath -m "$1")

"$here/install_dependencies.sh"
build_workspace
# catkin writes the prefix into the files that it installs.
cmake -DCMAKE_INSTALL_PREFIX="$folder" "$workspace/build" >/dev/null
cmake --install "$workspace/build" --strip >/dev/null
cmake -DCMAKE_INSTALL_PREFIX="$workspace/install" "$workspace/build" >/dev/null

# The packages of the libraries that programs and plugins link; apt-get adds their dependencies.
# setup.sh and describe_dataset.py need Python; ROS finds packages through a hook of setup.sh.
mapfile -t libraries < <(find "$folder" -type f -perm -u+r -exec objdump -p {} + 2>/dev/null |
  awk '$1 == "NEEDED" { print $2 }' | sort -u)
package_of() {  # PATTERNS of a file
  { dpkg-query -S "$@" 2>/dev/null || true; } | sed 's/:.*//' | grep . ||
    { echo "no package has $*" >&2; return 1; }
}
{
  echo python3
  package_of '*/etc/catkin/profile.d/1.ros_package_path.sh'
  for library in "${libraries[@]}"; do
    [ -n "$(find "$folder" -name "$library")" ] ||
      package_of "*/$(gcc -print-multiarch)/$library" "/opt/ros/*/lib/$library"
  done
} | sort -u >"$folder/packages.txt"
echo "$folder: $(du -sh "$folder" | cut -f1), and $(wc -l <"$folder/packages.txt") packages of packages.txt"
