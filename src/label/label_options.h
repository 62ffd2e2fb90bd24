#pragma once

#include <cstdint>

namespace synthetic_dataset::label {

/// Settings of the background subtraction, under OpenCV's names.
struct Mog2Options {
  int history_length = 100;      ///< pictures of the background that the model is trained on
  double var_threshold = 500.0;  ///< on the squared Mahalanobis distance of a pixel to the model
  bool detect_shadows = false;   ///< mark what is merely darker than the background as shadow
};

/// How masks are found.
enum class MaskMethod {
  kMog2,   ///< by background subtraction, as in the paper
  kExact,  ///< in the renderer's identifiers
};

struct MaskOptions {
  MaskMethod method = MaskMethod::kExact;
  bool method_is_given = false;  ///< otherwise it follows from `background_subtractor`
  label::Mog2Options mog2;
  bool clean = true;  ///< fill holes and remove specks
};

/// Which objects get labels.
struct LabelOptions {
  double min_visibility = 0.0;       ///< 0 .. 1; 0: no threshold
  std::int64_t min_pixels = 0;       ///< visible pixels; 0: no threshold
  double keypoint_tolerance = 0.01;  ///< [m] behind the seen surface, and still visible
  bool follows_rows = true;          ///< with a rolling shutter, labels are of each row's time

  [[nodiscard]] bool hasThresholds() const { return min_visibility > 0.0 || min_pixels > 0; }
};

/// By how much something has to be nearer to the camera than the world's surface at that pixel to
/// count as something that is not in the world: the errors of depth cameras, models and poses.
struct OcclusionMargin {
  double least = 0.1;    ///< [m]
  double growth = 0.02;  ///< of the distance

  [[nodiscard]] double at(double range) const { return least + growth * range; }
};

}  // namespace synthetic_dataset::label
