#include "run/setup/setup_notes.h"

#include <algorithm>

#include "label/pixel_labeller.h"

namespace synthetic_dataset::run {
namespace {

void noteEmptySplits(RunSetup& setup) {
  if (setup.instantCount() == 0) return;
  for (const SplitInfo& split : setup.splits->splits(setup.config.cameras.size())) {
    if (split.scene_count > 0) continue;
    setup.diagnostics.warning("split/" + split.name, "no scene falls into it");
  }
}

/// Users of nn_data_collection's settings may not know that there are exact masks.
void noteSubtraction(RunSetup& setup) {
  const label::MaskOptions& masks = setup.config.masks;
  if (masks.method == label::MaskMethod::kExact || masks.method_is_given) return;
  if (!setup.writers->requirements().visible_masks) return;
  setup.diagnostics.warning(
      "",
      "masks are found by background subtraction since background_subtractor is "
      "set; masks/method: exact gives exact ones");
}

/// What hides an object is found by those writers alone that ask for it.
void noteUnseen(RunSetup& setup) {
  const config::Config& config = setup.config;
  if (label::looksAtPixels(setup.writers->requirements(), config.masks, config.labels)) return;
  setup.diagnostics.note(
      "",
      "no writer of this run asks which pixels show an object: one that something "
      "hides is labelled as if it were seen (labels/min_pixels: 1 leaves it out)");
}

/// Noise of a picture that no format of this run has is a mistake.
void noteUnusedDepthNoise(RunSetup& setup) {
  if (setup.writers->requirements().depth) return;
  for (const scene::CameraOptions& camera : setup.config.cameras) {
    if (camera.depth_noise.model == render::DepthModel::kExact) continue;
    setup.diagnostics.warning(camera.group + "/depth_noise",
                              "no format of this run writes depth, so it has no effect");
  }
}

/// What is placed stands still: only drops of rain and flakes move then.
void noteIdleShutters(RunSetup& setup) {
  const bool all_are_placed =
      std::all_of(setup.motions.begin(), setup.motions.end(),
                  [](const MotionSetup& motion) { return motion.config.isPlaced(); });
  const auto& weather = setup.config.randomization.weather;
  if (!all_are_placed || weather.rain || weather.snow) return;
  for (const scene::CameraOptions& camera : setup.config.cameras) {
    const scene::Shutter& shutter = camera.shutter;
    if (shutter.exposure_time.count() == 0 && shutter.readout_time.count() == 0) continue;
    setup.diagnostics.warning(
        camera.group + "/effects",
        "exposure_time and readout_time have no effect, as what is placed stands still");
  }
}

}  // namespace

void noteWhatMaySurprise(RunSetup& setup) {
  if (setup.splits) noteEmptySplits(setup);
  noteIdleShutters(setup);
  if (!setup.writers) return;
  noteSubtraction(setup);
  noteUnseen(setup);
  noteUnusedDepthNoise(setup);
}

}  // namespace synthetic_dataset::run
