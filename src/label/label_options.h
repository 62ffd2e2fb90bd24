#pragma once

#include <cstdint>

#include "label/mog2_options.h"

namespace synthetic_dataset::label {

/// How masks are found.
enum class MaskMethod {
  kMog2,   ///< by background subtraction, as in the paper
  kExact,  ///< in the renderer's identifiers
};

struct MaskOptions {
  MaskMethod method = MaskMethod::kExact;
  bool method_is_given = false;  ///< else it follows from `background_subtractor`
  label::Mog2Options mog2;
  bool clean = true;  ///< fill holes and remove specks
};

/// Which objects get labels.
struct LabelOptions {
  double min_visibility = 0.0;       ///< 0 .. 1; 0: no threshold
  std::int64_t min_pixels = 0;       ///< visible ones; 0: no threshold
  double keypoint_tolerance = 0.01;  ///< [m] behind what is seen, and still visible

  [[nodiscard]] bool hasThresholds() const { return min_visibility > 0.0 || min_pixels > 0; }
};

}  // namespace synthetic_dataset::label
