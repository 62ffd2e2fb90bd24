#pragma once

#include <vector>

#include <Eigen/Core>

#include "run/align/outline_edges.h"

namespace synthetic_dataset::run {

/// A change of camera and time that brings outlines to their edges.
struct CameraFit {
  AlignmentVector change = AlignmentVector::Zero();
  AlignmentVector stddev =
      AlignmentVector::Zero();  ///< of each entry, the others being unknown too
};

/// What may change beside the camera's frame.
struct FitFreedom {
  bool time = true;
  bool focal_length = false;
};

/// The change by which outlines are nearest to their edges: least squares in which far ones count
/// less and less (Geman and McClure's loss), solved by reweighting. Outlines are linear in a small
/// change, so that this is exact for each weighting.
///
/// Its uncertainty takes the edges of one scene as depending on one another, as they do (Liang and
/// Zeger 1986, "sandwich"), and is at least that of edges known to a pixel, of which one in
/// `kAlike` is independent.
/// @param scenes  the edges of each scene
/// @param reach  how far the edges may be [px]
/// @param freedom  entries of what may not change stay 0
[[nodiscard]] CameraFit fitCamera(const std::vector<std::vector<OutlineEdge>>& scenes, double reach,
                                  const FitFreedom& freedom);

}  // namespace synthetic_dataset::run
