#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::run {

/// What an outline depends on: the shift [m] and the turn [rad] of the camera in its own frame, the
/// time [s] at which everything is where TF has it, and the logarithm of the focal length.
using AlignmentVector = Eigen::Matrix<double, 8, 1>;
constexpr Eigen::Index kTimeEntry = 6;
constexpr Eigen::Index kFocalEntry = 7;

/// A point of an outline, and the edge of the recorded picture that it should lie on.
struct OutlineEdge {
  double distance = 0.0;  ///< of the edge along the outline's normal [px]

  /// How much a small change moves the outline along its normal [px].
  AlignmentVector change = AlignmentVector::Zero();
};

/// What edges are looked for with.
struct OutlineSearch {
  double reach = 10.0;              ///< how far from the outline [px]
  Pose X_FC = Pose::Identity();     ///< of the picture's frame in that which is corrected
  std::optional<double> flow_time;  ///< the time that the optical flow is of [s]; none: unknown
};

/// The edges of a scene's picture along the outlines of its objects: of each point the strongest,
/// rather a near one. Points without a clear edge are left out, and so are those where something
/// else hides the object.
/// @param scene  with its recorded image, visible masks, depth and optical flow
[[nodiscard]] std::vector<OutlineEdge> findEdges(const Scene& scene, const OutlineSearch& search);

}  // namespace synthetic_dataset::run
