#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::run {

/// What an outline depends on: the translation [m] and rotation [rad] of the camera in its own
/// frame, the time [s] for which poses are taken from TF, and the logarithm of the focal length.
using AlignmentVector = Eigen::Matrix<double, 8, 1>;
constexpr Eigen::Index kTimeEntry = 6;
constexpr Eigen::Index kFocalEntry = 7;

/// A point of an outline and the edge in the recorded picture on which it should lie.
struct OutlineEdge {
  double distance = 0.0;  ///< to the edge along the outline's normal [px]

  /// Derivative of the outline's position along its normal [px] with respect to each entry.
  AlignmentVector change = AlignmentVector::Zero();
};

/// Parameters of the edge search.
struct OutlineSearch {
  double reach = 10.0;              ///< how far from the outline [px]
  Pose X_FC = Pose::Identity();     ///< of the picture's frame in the frame that is corrected
  std::optional<double> flow_time;  ///< time spanned by the optical flow [s]; nothing if unknown
};

/// Finds the edges of a scene's picture along the outlines of its objects: for each point the
/// strongest edge, with a preference for near ones. Points without a clear edge are left out, as
/// are those where something else occludes the object.
/// @param scene  with its recorded image, visible masks, depth and optical flow
[[nodiscard]] std::vector<OutlineEdge> findEdges(const Scene& scene, const OutlineSearch& search);

}  // namespace synthetic_dataset::run
