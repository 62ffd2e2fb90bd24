#pragma once

#include <vector>

#include "world/sdf/element.h"
#include "world/sdf/model_source.h"
#include "world/sdf/sdf_includes.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Reads the models of a `<population>`: copies of its `<model>`, called "name_clone_0" and so on,
/// placed by its distribution as in Gazebo Classic (Population.cc). Where Gazebo draws at random,
/// the numbers here depend only on the population's name, and are the same in all runs; where it
/// spreads models evenly by k-means, they follow a low-discrepancy sequence.
/// @param outer  the location of the world
[[nodiscard]] std::vector<ModelSource> readPopulation(const Element& population,
                                                      const SourceLocation& outer,
                                                      SdfIncludes& includes, SdfReading& reading);

}  // namespace synthetic_dataset::world
