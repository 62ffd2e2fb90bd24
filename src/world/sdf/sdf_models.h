#pragma once

#include <vector>

#include "world/sdf/model_source.h"
#include "world/sdf/sdf_reading.h"
#include "world/sdf/sdf_state.h"

namespace synthetic_dataset::world {

/// A model with the lights and sensors that its links carry.
struct ModelContents {
  Model model;
  std::vector<Light> lights;
  std::vector<CameraSensor> cameras;
  std::vector<LidarSensor> lidars;
};

/// Reads a model whose frames have been filled; links of nested models become its own,
/// "child::link". Lights and sensors are placed in the world according to the model's pose.
/// @param saved  what a saved world's state says about it, or null
[[nodiscard]] ModelContents readModel(ModelSource& source, const Pose& X_WM,
                                      const SavedModel* saved, SdfReading& reading);

}  // namespace synthetic_dataset::world
