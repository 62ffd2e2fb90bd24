#!/usr/bin/env bash
# Makes docs/images/run.gif: the bundled example's scenes with the labels of their COCO files.
#   ./scripts/draw_run.sh [FILE.gif]
# Built and sourced before: the workspace, as by demo.sh.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
file=${1:-$repository/docs/images/run.gif}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

rosrun synthetic_dataset generate --config "$repository/config/example.yaml" \
  output_folder:="$scratch/dataset"
rosrun synthetic_dataset draw_labels --video "$scratch/run.mp4" "$scratch/dataset" coco
# A palette of the film's own colours; of a still camera, only what changes is stored.
ffmpeg -v error -y -i "$scratch/run.mp4" -vf "fps=8,scale=400:-1:flags=lanczos,split[a][b];\
[a]palettegen=max_colors=128:stats_mode=diff[p];\
[b][p]paletteuse=dither=bayer:bayer_scale=5:diff_mode=rectangle" "$file"
