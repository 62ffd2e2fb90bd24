#pragma once

#include "run/setup/run_setup.h"

namespace synthetic_dataset::run {

/// Notes what of a run's settings has another effect than its user may think: splits without
/// scenes, masks by background subtraction, hidden objects with labels, noise of depth that nobody
/// writes.
/// @param setup  with its splits and writers, as far as they could be made
void noteWhatMaySurprise(RunSetup& setup);

}  // namespace synthetic_dataset::run
