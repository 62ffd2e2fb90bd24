#pragma once

#include <vector>

#include <Eigen/Core>

#include "run/align/outline_edges.h"

namespace synthetic_dataset::run {

/// A change of camera and time that moves outlines onto their edges.
struct CameraFit {
  AlignmentVector change = AlignmentVector::Zero();
  AlignmentVector stddev =
      AlignmentVector::Zero();  ///< of each entry, with the other entries unknown as well
};

/// What may change in addition to the camera's frame.
struct FitFreedom {
  bool time = true;
  bool focal_length = false;
};

/// The change that brings outlines closest to their edges: robust least squares that discounts
/// distant edges (Geman and McClure's loss), solved by iterative reweighting. Outlines are linear
/// in a small change, so the solution is exact for each weighting.
///
/// Its uncertainty accounts for the correlation of edges within a scene (Liang and Zeger 1986,
/// "sandwich" estimator), and is at least that of edges located to a pixel of which one in `kAlike`
/// is independent.
/// @param scenes  the edges of each scene
/// @param reach  how far away the edges may be [px]
/// @param freedom  entries that may not change stay 0
[[nodiscard]] CameraFit fitCamera(const std::vector<std::vector<OutlineEdge>>& scenes, double reach,
                                  const FitFreedom& freedom);

}  // namespace synthetic_dataset::run
