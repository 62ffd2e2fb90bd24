#pragma once

#include <cstddef>
#include <optional>

#include "run/align/outline_edges.h"
#include "run/reporter.h"
#include "synthetic_dataset/pose.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// How a camera's clock and frame differ from those of TF, found from its recorded pictures.
struct CameraAlignment {
  Duration time_offset{0};       ///< the setting: in all, with what was set before
  Pose X_FD = Pose::Identity();  ///< the setting camera/correction, likewise
  AlignmentVector stddev = AlignmentVector::Zero();  ///< of shift [m], turn [rad] and time [s]
  bool knows_time = false;  ///< else nothing moves enough to tell, and the offset is what was set
  std::size_t scenes = 0;   ///< that were looked at
  std::optional<double> before;  ///< the alignment of all outlines (label::Alignment)
  std::optional<double> after;
};

/// Finds the time offset and the correction with which the labels of recorded pictures meet the
/// pictures' edges. It draws the scenes, looks along each outline's normals for edges, and moves
/// camera and time such that outlines come to lie on them; again and again, with edges looked for
/// ever nearer.
///
/// The score itself is no function for an optimiser with gradients: it is counted in whole pixels
/// and has its slopes only near its maximum. What is solved instead is linear in seven unknowns.
/// @param parameters  a run's settings, of one camera with an image_topic and one motion
/// @param scene_count  how many of the recording's pictures are taken, evenly spread; > 0
/// @throws ErrorList with all that is wrong
[[nodiscard]] CameraAlignment alignCamera(const Value& parameters, std::size_t scene_count,
                                          Reporter& reporter);

}  // namespace synthetic_dataset::run
