#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// What a saved world's `<state>` says about a model.
struct SavedModel {
  std::optional<Pose> X_WM;
  Eigen::Vector3d scale{1, 1, 1};    ///< of its visuals and collisions, not of their poses
  std::map<std::string, Pose> X_WL;  ///< by the link's scoped name: "arm::wrist"
};

/// The `<state>` of a world that Gazebo saved: where everything was when it was saved.
struct SavedState {
  std::map<std::string, SavedModel> models;
  std::map<std::string, Pose> lights;
  std::vector<Element> inserted;  ///< models and lights
  std::set<std::string> deleted;  ///< names of models and lights
};

[[nodiscard]] SavedState readState(const Element& world, const SourceLocation& location,
                                   SdfReading& reading);

}  // namespace synthetic_dataset::world
