#!/usr/bin/env bash
# Makes the bundled example on other releases of Debian, as a user of a bare system does, and
# compares its files with those that are made here.
#   ./scripts/test_systems.sh [--tests|--prepare] [bullseye|trixie]...    both by default
# --tests runs all tests there as well; --prepare only installs what is needed, while something else
# uses the processor. Each release takes some 15 minutes the first time, and 3 GB in
# ~/.cache/synthetic_dataset/systems; only root can run this.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"
# shellcheck source=systems.sh
source "$here/systems.sh"

what=example
names=()
for argument in "$@"; do
  case $argument in
    --tests | --prepare) what=${argument#--} ;;
    bullseye | trixie) names+=("$argument") ;;
    *) echo "'$argument' is no system: bullseye or trixie" >&2; exit 2 ;;
  esac
done
[ ${#names[@]} -gt 0 ] || names=(bullseye trixie)

problem=$(systems_problem)
if [ -n "$problem" ]; then
  echo "other systems (${names[*]}): not tested, as $problem"
  exit 0
fi

if [ "$what" = prepare ]; then
  for name in "${names[@]}"; do
    make_system "$name"
    in_system "$name" "$systems" /repository/scripts/install_dependencies.sh
  done
  exit 0
fi

exchange=$systems/exchange
rm -rf "$exchange"
mkdir -p "$exchange"
"$here/install_dependencies.sh"
build_workspace
use_workspace
# All datasets are made under the same path, which some formats write into their lists.
example=$exchange/example
rosrun synthetic_dataset generate --config "$repository/config/example.yaml" \
  output_folder:="$example" >"$exchange/here.log" 2>&1 || { tail -n 20 "$exchange/here.log"; exit 1; }
mv "$example" "$exchange/here"

failed=0
for name in "${names[@]}"; do
  echo "== $name"
  start=$SECONDS
  rm -rf "$example"
  make_system "$name"
  # A port of its own, so that no ROS master on this machine interferes.
  in_system "$name" "$exchange" env ROS_MASTER_URI=http://localhost:11399 \
    /repository/scripts/demo.sh "$example" >"$exchange/$name.log" 2>&1 || {
    tail -n 40 "$exchange/$name.log"
    echo "$name: the example is not made; see $exchange/$name.log"
    failed=1
    continue
  }
  mv "$example" "$exchange/$name"
  # Mesa 20 rounds some pixels differently from Mesa 22.
  rounding=0
  [ "$name" != bullseye ] || rounding=0.001
  "$here/compare_datasets.py" --rounding "$rounding" "$exchange/here" "$exchange/$name" || failed=1
  if [ "$what" = tests ]; then
    in_system "$name" "$exchange" /repository/scripts/test.sh || failed=1
  fi
  echo "$name: $((SECONDS - start)) s"
done
exit $failed
