#pragma once

#include <string>

#include "synthetic_dataset/pose.h"

/// The files of a PVNet dataset's folder `pose`.
namespace synthetic_dataset {

/// The content of a file that numpy.load reads as a pose's 3 x 4 matrix [R | t].
[[nodiscard]] std::string numpyPose(const Pose& pose);

/// The pose in such a file.
/// @param bytes  the whole file; the last 96 bytes are the matrix
/// @throws Error if there are too few
[[nodiscard]] Pose poseOfNumpy(const std::string& bytes);

}  // namespace synthetic_dataset
