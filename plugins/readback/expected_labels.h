#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "synthetic_dataset/box.h"
#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/pose.h"

/// What labels should be, as far as the measures in a manifest say.
namespace synthetic_dataset::formats {

/// What was measured of an object in a scene; what nobody asked for is nothing. The members are
/// those of SceneObject.
struct MeasuredObject {
  std::string name;
  std::string id;
  std::string class_name;
  std::string class_text;
  int class_id = 0;
  std::optional<Pose> X_CO = {};  ///< nothing where it is not in the scene
  bool in_view = false;
  bool dropped = false;
  std::optional<Box> loose_box = {};
  std::optional<Box> silhouette_box = {};
  std::optional<Box> visible_box = {};
  std::optional<std::int64_t> silhouette_pixels = {};
  std::optional<std::int64_t> visible_pixels = {};
  std::optional<double> truncation = {};

  bool is_subtracted = false;  ///< its masks are not those of the identifiers in this scene
  bool is_warned_of = false;   ///< the writer has warned that it has no label in this scene

  [[nodiscard]] bool isSeen() const { return visible_pixels.value_or(0) > 0; }
  [[nodiscard]] bool labelled() const { return isSeen() && !dropped; }
};

struct MeasuredScene {
  cv::Size size;  ///< of the image [px]

  /// Whether masks are those of identifiers, so that the exact measures count their pixels.
  bool has_exact_masks = true;

  std::vector<MeasuredObject> objects;

  /// From the first pixel's edge to the last one's.
  [[nodiscard]] Box image() const { return {-0.5, -0.5, size.width - 0.5, size.height - 0.5}; }

  /// The box that a label has, cut to the image.
  [[nodiscard]] std::optional<Box> box(const MeasuredObject& object, BoxChoice choice) const;

  /// The silhouette's box where all of it is in the image and it is that of the masks.
  [[nodiscard]] std::optional<Box> wholeSilhouette(const MeasuredObject& object) const;
};

/// What numbers lose on their way through JSON or the manifest, and in sums of them [px].
constexpr double kRounding = 1e-6;

/// A label that a format's files should have. What is nothing is not known, or has no exact value
/// in the format.
struct ExpectedLabel {
  std::string object;            ///< whose it is: the object's name
  std::string class_name;        ///< as the format has it; empty where it has none
  std::string object_name = "";  ///< as the format has it; empty where it has none

  std::optional<Box> box = {};
  double box_tolerance = 0.0;  ///< what the format's decimals leave of an edge [px]

  std::optional<Box> mask_bounds = {};           ///< tight box around the mask
  std::optional<std::int64_t> mask_pixels = {};  ///< how many pixels the mask has
  std::optional<Box> polygon_bounds = {};        ///< of all polygons' points
  double polygon_tolerance = 0.0;                ///< [px]
  std::optional<double> polygon_area = {};       ///< that the polygons enclose [px^2]
  std::optional<Pose> X_CO = {};

  bool may_lack = false;  ///< whether it may be missing

  /// With what the visible mask has in any format.
  void setVisibleMask(const MeasuredScene& scene, const MeasuredObject& of);
};

/// The labels that one writer's files should have of a scene.
struct ExpectedLabels {
  std::vector<ExpectedLabel> labels;
  std::vector<ExpectedLabel> masks;  ///< that the format has apart from its labels
  bool has_masks_apart = false;
};

}  // namespace synthetic_dataset::formats
