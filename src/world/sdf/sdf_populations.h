#pragma once

#include <vector>

#include "world/sdf/element.h"
#include "world/sdf/model_source.h"
#include "world/sdf/sdf_includes.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// The models of a `<population>`: its `<model>` again and again, called "name_clone_0" and so on,
/// where its distribution puts them, as Gazebo Classic does (Population.cc). What Gazebo draws at
/// random is drawn by the population's name here, the same in all runs; what it spreads evenly by
/// k-means follows a sequence of low discrepancy.
/// @param outer  the location of the world
[[nodiscard]] std::vector<ModelSource> readPopulation(const Element& population,
                                                      const SourceLocation& outer,
                                                      SdfIncludes& includes, SdfReading& reading);

}  // namespace synthetic_dataset::world
