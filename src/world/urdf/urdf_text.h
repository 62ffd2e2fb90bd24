#pragma once

#include "world/files/findings.h"
#include "world/sdf/sdf_file.h"

namespace synthetic_dataset::world {

/// Resolves what roslaunch and xacro may have left in a URDF: `$(optenv NAME default)` and `$(env
/// NAME)` from the environment, `$(find package)` and `$(find-pkg-share package)` as
/// `package://package`. An attribute with any other substitution is left out, and noted. Blocks for
/// other programs (<gazebo>, <transmission>, ...) stay as they are.
/// @return false if the text has not been through xacro, with the error reported
[[nodiscard]] bool prepareUrdf(const SdfFile& urdf, SdfFile& prepared, Findings& findings);

}  // namespace synthetic_dataset::world
