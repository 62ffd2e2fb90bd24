#pragma once

#include <string>

#include "synthetic_dataset/pose.h"

/// The files of a PVNet dataset's folder `pose`.
namespace synthetic_dataset {

/// The bytes of a file that numpy.load reads as a pose's 3 x 4 matrix [R | t].
[[nodiscard]] std::string numpyPose(const Pose& pose);

/// The pose of such a file.
/// @param bytes  of the whole file; the last 96 are the matrix
/// @throws Error where they are too few
[[nodiscard]] Pose poseOfNumpy(const std::string& bytes);

}  // namespace synthetic_dataset
