#pragma once

namespace synthetic_dataset::label {

/// Settings of the background subtraction, under OpenCV's names.
struct Mog2Options {
  int history_length = 100;      ///< pictures of the background that the model is trained on
  double var_threshold = 500.0;  ///< on the squared Mahalanobis distance of a pixel to the model
  bool detect_shadows = false;   ///< mark what is only darker than the background as shadow
};

}  // namespace synthetic_dataset::label
