#pragma once

#include <array>

#include <Eigen/Core>

#include "render/pixels/lanes.h"
#include "world/look.h"

namespace synthetic_dataset::render {

/// The light of a panorama that lies around the world. What arrives at a surface varies slowly with
/// its normal: nine numbers a colour are enough (Ramamoorthi and Hanrahan 2001, "An Efficient
/// Representation for Irradiance Environment Maps"). Highlights of what is bright and small are
/// lost.
class EnvironmentLight {
 public:
  /// @param panorama  of this projection
  explicit EnvironmentLight(const world::BackgroundPicture& panorama);

  /// What arrives from the half of the world that surfaces face, as their cosine counts: linear
  /// red, green and blue; 1 where all of it is white.
  /// @param normals_G  unit vectors of the global frame
  [[nodiscard]] Lanes3 arriving(const Lanes3& normals_G) const;

 private:
  std::array<Eigen::Vector3f, 9> factors_;  ///< of the terms of a polynomial of the normal
};

}  // namespace synthetic_dataset::render
