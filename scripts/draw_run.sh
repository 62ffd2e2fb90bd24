#!/usr/bin/env bash
# Makes pictures for the documentation: docs/images/run.gif, the bundled example's scenes with the labels of
# their COCO files, docs/randomize.jpg, the scenes of config/example_placement.yaml, and
# docs/images/weather.jpg, one scene without weather, in fog, in rain and in snow.
#   ./scripts/draw_run.sh [FOLDER]    puts them into FOLDER (docs)
# The workspace has to be built, as by demo.sh, and sourced.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=${1:-$repository/docs}
mkdir -p "$folder/images"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

rosrun synthetic_dataset generate --config "$repository/config/example.yaml" \
  output_folder:="$scratch/dataset"
rosrun synthetic_dataset draw_labels --video "$scratch/run.mp4" "$scratch/dataset" coco
# With a palette of the film's own colours; while the camera stands still, only what changes is stored.
ffmpeg -v error -y -i "$scratch/run.mp4" -vf "fps=5,scale=360:-1:flags=lanczos,split[a][b];\
[a]palettegen=max_colors=96:stats_mode=diff[p];\
[b][p]paletteuse=dither=bayer:bayer_scale=5:diff_mode=rectangle" "$folder/images/run.gif"

rosrun synthetic_dataset generate --config "$repository/config/example_placement.yaml" \
  output_folder:="$scratch/placed"
ffmpeg -v error -y -pattern_type glob -i "$scratch/placed/coco/images/*.png" -frames:v 1 -q:v 4 \
  -vf "scale=256:-1:flags=area,tile=5x5:padding=4:margin=2:color=white" "$folder/randomize.jpg"

weathers=0
for weather in "{}" "{visibility: 12}" "{rain: 60}" "{snow: 1}"; do
  rosrun synthetic_dataset generate --config "$repository/config/example.yaml" only_scenes:=[6] \
    randomize/weather:="$weather" output_folder:="$scratch/weather" if_exists:=overwrite
  cp "$scratch/weather/coco/images/00000006.png" "$scratch/in_weather_$((++weathers)).png"
done
ffmpeg -v error -y -pattern_type glob -i "$scratch/in_weather_*.png" -frames:v 1 -q:v 5 \
  -vf "scale=480:-1:flags=area,tile=2x2:padding=4:color=white" "$folder/images/weather.jpg"
