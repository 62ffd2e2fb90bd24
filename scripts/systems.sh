# Sourced after workspace.sh: other releases of Debian, each in a folder in which programs run as if
# it were the machine's root. debootstrap makes them from Debian's mirror; they are kept with
# everything that is installed and built in them.

systems=${XDG_CACHE_HOME:-$HOME/.cache}/synthetic_dataset/systems
mirror=${SYNTHETIC_DATASET_MIRROR:-http://deb.debian.org/debian}

# Prints why other systems cannot be made on this machine; nothing if they can.
systems_problem() {
  if [ "$(id -u)" -ne 0 ]; then
    echo "only root can make them"
  elif ! command -v apt-get >/dev/null; then
    echo "debootstrap comes from Debian's packages, and there is no apt-get"
  elif ! unshare --mount mount --make-rprivate / 2>/dev/null; then
    echo "mounts are not allowed here"
  fi
}

# make_system NAME [RELEASE]: makes a bare system, unless it exists.
make_system() {
  local root=$systems/$1 release=${2:-$1}
  [ ! -d "$root" ] || return 0
  "$repository/scripts/install_dependencies.sh" debootstrap
  echo "Making a bare $release in $root"
  rm -rf "$root.new"
  mkdir -p "$root.new/etc/dpkg/dpkg.cfg.d"
  # Whatever is lost in a crash can be made again, so dpkg need not wait for the disk.
  echo force-unsafe-io >"$root.new/etc/dpkg/dpkg.cfg.d/unsafe-io"
  debootstrap --variant=minbase "$release" "$root.new" "$mirror" >"$root.log" 2>&1 || {
    tail -n 20 "$root.log"
    return 1
  }
  mv "$root.new" "$root"
}

# in_system NAME FOLDER COMMAND...: runs a command in a system, where the repository is /repository,
# read-only, and FOLDER has its own name.
in_system() {
  local root=$systems/$1
  mkdir -p "$root/repository" "$2" "$root$2"
  cp /etc/hosts "$root/etc/hosts"  # debootstrap makes none, and a ROS master needs `localhost`
  # shellcheck disable=SC2016
  unshare --mount bash -euc '
    mount --make-rprivate /
    mount --bind "$2" "$1/repository"
    mount -o remount,bind,ro "$1/repository"
    mount --bind "$3" "$1$3"
    mount -t proc proc "$1/proc"
    mount -t tmpfs tmpfs "$1/dev/shm"
    exec chroot "$1" /usr/bin/env -i HOME=/root LANG=C.UTF-8 TERM="${TERM:-dumb}" \
      PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "${@:4}"
  ' in_system "$root" "$repository" "$2" "${@:3}"
}
