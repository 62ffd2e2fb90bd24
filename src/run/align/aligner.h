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
  AlignmentVector stddev = AlignmentVector::Zero();  ///< see AlignmentVector
  double focal_scale = 1.0;                          ///< the setting camera/focal_scale, likewise
  bool knows_time = false;       ///< else nothing moves enough, and the offset is what was set
  std::size_t scenes = 0;        ///< that were looked at
  std::optional<double> before;  ///< the alignment of all outlines (label::Alignment)
  std::optional<double> after;
};

/// What to look for, and in how much.
struct AlignOptions {
  std::size_t scene_count = 60;  ///< of the recording's pictures, evenly spread; > 0
  bool focal_length = false;     ///< else that of the calibration is right
};

/// Finds the time offset and the correction with which the labels of recorded pictures meet the
/// pictures' edges. It draws the scenes, looks along each outline's normals for edges, and moves
/// camera and time such that outlines come to lie on them; again and again, with edges looked for
/// ever nearer.
///
/// The score itself does not suit an optimiser with gradients: it is counted in whole pixels
/// and has its slopes only near its maximum. What is solved instead is linear in seven or eight
/// unknowns.
/// @param parameters  a run's settings, of one camera with an image_topic and one motion
/// @throws ErrorList with all that is wrong
[[nodiscard]] CameraAlignment alignCamera(const Value& parameters, const AlignOptions& options,
                                          Reporter& reporter);

}  // namespace synthetic_dataset::run
