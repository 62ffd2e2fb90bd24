#pragma once

#include "base/diagnostics.h"
#include "run/setup/run_setup.h"
#include "scene/object_options.h"
#include "synthetic_dataset/cuboid.h"

namespace synthetic_dataset::run {

/// Notes what of a run's settings has another effect than its user may think: splits without
/// scenes, masks by background subtraction, hidden objects with labels, noise of depth that nobody
/// writes.
/// @param setup  with its splits and writers, as far as they could be made
void noteWhatMaySurprise(RunSetup& setup);

/// Warns of a bounding shape or keypoints that have little to do with the object's model, as
/// numbers in millimetres have.
/// @param box_O  around the model, in the object's frame
void checkSizes(const scene::ObjectOptions& object, const Cuboid& box_O,
                base::Diagnostics& diagnostics);

/// Warns of intrinsics of another resolution, and of a lens that sees next to nothing.
void noteStrangeLens(const scene::CameraOptions& camera, const CameraModel& model,
                     base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::run
