#pragma once

namespace synthetic_dataset::label {

/// By how much something has to be nearer to the camera than what the world has there, to be
/// something that the world does not have: what depth cameras, models and poses err.
struct OcclusionMargin {
  double least = 0.1;    ///< [m]
  double growth = 0.02;  ///< of the distance

  [[nodiscard]] double at(double range) const { return least + growth * range; }
};

}  // namespace synthetic_dataset::label
