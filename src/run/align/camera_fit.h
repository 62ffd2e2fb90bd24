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

/// The change by which outlines are nearest to their edges: least squares in which far ones count
/// less and less (Geman and McClure's loss), solved by reweighting. Outlines are linear in a small
/// change, so that this is exact for each weighting.
///
/// Its uncertainty takes the edges of one scene as depending on one another, as they do (Liang and
/// Zeger 1986, "sandwich"), and is at least that of edges known to a pixel, of which one in
/// `kAlike` is independent.
/// @param scenes  the edges of each scene
/// @param reach  how far the edges may be [px]
/// @param may_move_time  else the last entry stays 0
[[nodiscard]] CameraFit fitCamera(const std::vector<std::vector<OutlineEdge>>& scenes, double reach,
                                  bool may_move_time);

}  // namespace synthetic_dataset::run
