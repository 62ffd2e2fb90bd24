#pragma once

#include "base/diagnostics.h"
#include "run/setup/run_setup.h"
#include "scene/object_options.h"
#include "synthetic_dataset/cuboid.h"

namespace synthetic_dataset::run {

/// Notes settings whose effect may surprise the user: splits without scenes, masks by background
/// subtraction, hidden objects with labels, noise on depth that is not written.
/// @param setup  with its splits and writers, as far as they could be made
void noteSurprisingSettings(RunSetup& setup);

/// Warns of a bounding shape or keypoints that do not fit the object's model, such as numbers in
/// millimetres.
/// @param box_O  around the model, in the object's frame
void checkSizes(const scene::ObjectOptions& object, const Cuboid& box_O,
                base::Diagnostics& diagnostics);

/// Warns of intrinsics for another resolution, and of a lens that sees next to nothing.
void noteStrangeLens(const scene::CameraOptions& camera, const CameraModel& model,
                     base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::run
