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
  Duration time_offset{0};       ///< the value to set, earlier setting included
  Pose X_FD = Pose::Identity();  ///< camera/correction, earlier setting included
  AlignmentVector stddev = AlignmentVector::Zero();  ///< see AlignmentVector
  double focal_scale = 1.0;                          ///< camera/focal_scale, earlier included
  bool knows_time = false;  ///< if not, too little moves, and the offset is the earlier setting
  std::size_t scenes = 0;   ///< number used
  std::optional<double> before;  ///< alignment of all outlines before the fit (label::Alignment)
  std::optional<double> after;
};

/// What to estimate, and from how many scenes.
struct AlignOptions {
  std::size_t scene_count = 60;  ///< taken evenly from the recording's pictures; > 0
  bool focal_length = false;     ///< whether to estimate it; if not, the calibration's is used
};

/// Finds the time offset and the correction that align the labels of recorded pictures with the
/// pictures' edges. It draws the scenes, searches along each outline's normals for edges, and
/// adjusts camera and time so that outlines lie on them; it repeats this with an ever smaller
/// search range.
///
/// The score itself does not suit a gradient-based optimiser: it is counted in whole pixels and
/// slopes only near its maximum. The problem solved instead is linear in seven or eight unknowns.
/// @param parameters  a run's settings, with one motion and one camera that has an image_topic
/// @throws ErrorList with everything that is wrong
[[nodiscard]] CameraAlignment alignCamera(const Value& parameters, const AlignOptions& options,
                                          Reporter& reporter);

}  // namespace synthetic_dataset::run
