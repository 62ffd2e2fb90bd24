#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/lens/ray_grid.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// A pinhole picture of a part of what a lens sees.
struct LensFace {
  CameraModel camera;
  Pose X_CF = Pose::Identity();  ///< of the face's optical frame in the lens's; a pure rotation
  std::optional<NearLimit> near_limit = std::nullopt;  ///< in the face's frame
};

/// How a picture through a lens with distortion is assembled from pinhole pictures.
///
/// A lens with a narrow field of view has one face, which looks in the lens's direction; a wide one
/// has those sides of a cube that it sees. The faces have about four pixels for each of the
/// picture's where the latter lie closest together. Large faces are cut into tiles.
struct LensMap {
  std::vector<LensFace> faces;
  cv::Mat rays;  ///< CV_32FC3: the unit vector that each pixel's centre looks along (C)
  cv::Mat face;  ///< CV_16SC1: the pixel's index in `faces`; -1 where the lens sees nothing

  /// Whether this is a pinhole camera, for which OpenGL draws the other pictures: textures are then
  /// looked up as OpenGL does.
  bool is_pinhole = false;

  /// The pixels that look at each face, as row-major indices of the image; about one in a cell
  /// where they lie closest together.
  std::vector<RayGrid> grids;
};

[[nodiscard]] LensMap makeLensMap(const CameraModel& camera);

/// Whether pictures of the camera need a LensMap.
[[nodiscard]] bool hasDistortion(const CameraModel& camera);

/// The intrinsics of a face in cells of LensMap::grids.
[[nodiscard]] Intrinsics intrinsicsInCells(const LensFace& face);

/// Computes where rays of the lens's frame meet a face, in cells of LensMap::grids.
class FacePlane {
 public:
  explicit FacePlane(const LensFace& face)
      : R_FC_(face.X_CF.linear().transpose()), k_(intrinsicsInCells(face)) {}

  [[nodiscard]] Eigen::Vector2f placeOf(const cv::Vec3f& ray_C) const {
    const Eigen::Vector3d d = R_FC_ * Eigen::Vector3f(ray_C.val).cast<double>();
    return {static_cast<float>(k_.fx * d.x() / d.z() + k_.cx),
            static_cast<float>(k_.fy * d.y() / d.z() + k_.cy)};
  }

 private:
  Eigen::Matrix3d R_FC_;
  Intrinsics k_;
};

/// The place on a face [px] at which a ray of the lens's frame meets it.
[[nodiscard]] inline cv::Point2f placeOn(const LensFace& face, const cv::Vec3f& ray_C) {
  const auto& R = face.X_CF.linear();
  const Eigen::Vector3d d =
      R.transpose() * Eigen::Vector3d(static_cast<double>(ray_C[0]), static_cast<double>(ray_C[1]),
                                      static_cast<double>(ray_C[2]));
  const Intrinsics& k = face.camera.intrinsics();
  return {static_cast<float>(k.fx * d.x() / d.z() + k.cx),
          static_cast<float>(k.fy * d.y() / d.z() + k.cy)};
}

/// On which side of a pixel to look for its neighbour: 1 if the neighbour there looks at the plane
/// too; -1 if only the one on the other side does, as at the image's or the lens's rim; 0 if
/// neither does.
/// @param X_CF  of the plane, whose normal is its z axis
/// @param du  1 (with `dv` 0) for the neighbour in the row, 0 (with `dv` 1) for that in the column
[[nodiscard]] int neighbourSide(const LensMap& map, const Pose& X_CF, int u, int v, int du, int dv);

}  // namespace synthetic_dataset::render
