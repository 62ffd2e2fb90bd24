#pragma once

#include <vector>

#include <sdf/Model.hh>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// A model with what its links carry.
struct ModelContents {
  Model model;
  std::vector<Light> lights;
  std::vector<CameraSensor> cameras;
};

/// Whether a model only stands in for one that is missing.
[[nodiscard]] bool isStandIn(const sdf::Model& model);

/// Reads a model; links of nested models become its own, "child::link". Lights and cameras are
/// placed in the world by the model's pose.
/// @param place  the file's
[[nodiscard]] ModelContents readModel(const sdf::Model& model, const Pose& X_WM, const Place& place,
                                      SdfReading& reading);

}  // namespace synthetic_dataset::world
