#pragma once

#include "plugins/bop/bop_models.h"

namespace synthetic_dataset {

/// Reads an object's symmetries: `discrete`, transforms of 16 numbers each, row by row [m], and
/// `continuous`, axes with an offset [m]; both in the object's frame. Notes errors.
/// @param model  gets them, in its own frame, instead of those that it has
void readSymmetries(Parameters parameters, BopModel& model);

}  // namespace synthetic_dataset
