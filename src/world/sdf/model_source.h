#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/description.h"
#include "world/files/findings.h"
#include "world/sdf/element.h"
#include "world/sdf/sdf_frames.h"
#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {

/// A model as its file has it, with what an `<include>` says instead of the file.
struct ModelSource {
  enum class Kind { kModel, kUrdf, kLight, kActor, kNothing };

  Kind kind = Kind::kModel;
  Element element;  ///< `<model>`, `<light>`, `<actor>`, or the root of a URDF
  std::string name;
  RelativePose pose;
  std::string placement_frame;  ///< whose pose `pose` is; empty: the model's own frame
  bool is_static = false;
  std::optional<int> label;         ///< that gz-sim's label plugin gives it
  bool merges = false;              ///< what is in it belongs to the model around it
  bool has_gaps = false;            ///< a model in it is missing, which has been reported
  std::vector<ModelSource> models;  ///< those within it, in the order of the file
  SourceLocation location{""};
  SdfFrames frames;                   ///< the names in it; filled by fillFrames
  std::shared_ptr<const Model> urdf;  ///< what a URDF holds; filled by fillFrames
};

/// Where a model stands, by its own frame.
[[nodiscard]] RelativePose placed(ModelSource& source, SdfReading& reading);

/// Fills the frames of a model and of those within it.
void fillFrames(ModelSource& source, SdfReading& reading);

}  // namespace synthetic_dataset::world
