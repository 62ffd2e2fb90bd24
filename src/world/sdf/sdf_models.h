#pragma once

#include <vector>

#include "world/sdf/model_source.h"
#include "world/sdf/sdf_reading.h"
#include "world/sdf/sdf_state.h"

namespace synthetic_dataset::world {

/// A model with what its links carry.
struct ModelContents {
  Model model;
  std::vector<Light> lights;
  std::vector<CameraSensor> cameras;
  std::vector<LidarSensor> lidars;
};

/// Reads a model whose frames are filled; links of nested models become its own, "child::link".
/// Lights and sensors are placed in the world by the model's pose.
/// @param saved  what a saved world's state says of it, or null
[[nodiscard]] ModelContents readModel(ModelSource& source, const Pose& X_WM,
                                      const SavedModel* saved, SdfReading& reading);

}  // namespace synthetic_dataset::world
