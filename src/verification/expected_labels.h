#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "output/manifest/run_description.h"
#include "output/manifest/scene_facts.h"
#include "output/store_types.h"
#include "synthetic_dataset/box.h"
#include "synthetic_dataset/pose.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset {

/// A label that a format's files should have, as the manifest's measures say. What is nothing is
/// not known, or has no exact value in the format.
struct ExpectedLabel {
  std::string object;       ///< whose it is: the object's name
  std::string class_name;   ///< as the format has it
  std::string object_name;  ///< as the format has it; empty where it has none

  std::optional<Box> box;
  double box_tolerance = 0.0;  ///< what the format's decimals leave of an edge [px]

  std::optional<Box> mask_bounds;           ///< tight box round the mask
  std::optional<std::int64_t> mask_pixels;  ///< how many pixels the mask has
  std::optional<Box> polygon_bounds;        ///< of all polygons' points
  double polygon_tolerance = 0.0;           ///< [px]
  std::optional<double> polygon_area;       ///< that the polygons enclose [px^2]
  std::optional<Pose> X_CO;

  bool may_lack = false;  ///< the run has warned that it has no label here
};

/// The labels that one writer's files should have of a scene.
struct ExpectedLabels {
  std::vector<ExpectedLabel> labels;
  std::vector<ExpectedLabel> masks;  ///< that the format has apart from its labels
  bool has_masks_apart = false;
};

/// What a run's manifest tells that decides how a writer's labels are.
struct LabelRules {
  const output::RunDescription& run;
  const std::map<std::string, Value>& settings;  ///< by their names
  const output::StoreWriter& writer;
  cv::Size image;  ///< of the scene's camera [px]
};

/// Whether a format's labels are known to `expectedLabels`, by a writer's type.
[[nodiscard]] bool hasLabelRules(const std::string& type);

/// Whether a format's labels can only be read when the files of the dataset as a whole are there.
[[nodiscard]] bool needsDatasetFiles(const std::string& type);

/// @param rules  of a writer of which hasLabelRules is true
[[nodiscard]] ExpectedLabels expectedLabels(const output::SceneFacts& scene,
                                            const LabelRules& rules);

}  // namespace synthetic_dataset
