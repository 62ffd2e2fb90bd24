#!/usr/bin/env bash
# Draws with both of the platforms that give access to Mesa's llvmpipe, OSMesa and EGL: runs the renderer's tests with
# EGL, makes the bundled example with each platform, and compares all bytes.
#   ./scripts/test_egl.sh
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=workspace.sh
source "$here/workspace.sh"

"$here/install_dependencies.sh" libegl-dev libgl1-mesa-dri
build_workspace --target test_render --target generate --target synthetic_dataset_writers
use_workspace
SYNTHETIC_DATASET_GL=egl "$here/run_tests.py" "$workspace" --all test_render
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for platform in osmesa egl; do
  SYNTHETIC_DATASET_GL=$platform "$workspace/devel/lib/synthetic_dataset/generate" \
    --config "$repository/config/example.yaml" "output_folder:=$scratch/dataset" simulated_rate:=2
  mv "$scratch/dataset" "$scratch/$platform"
done
diff -rq "$scratch/osmesa" "$scratch/egl"
echo "OSMesa and EGL: all bytes equal"
