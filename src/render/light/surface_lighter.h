#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "render/geometry/geometry_buffer.h"
#include "render/light/surface_shading.h"
#include "render/parts/draw_list.h"

namespace synthetic_dataset::render {

/// What of a part's light is the same all over it.
struct PartLight {
  Eigen::Vector3f emissive{0.0F, 0.0F, 0.0F};  ///< linear
  float reflectance = 0.0F;                    ///< below 0 where light leaves it as it is
};

/// By the number that parts have in GeometryImages.
[[nodiscard]] std::vector<PartLight> partLights(const std::vector<Part>& parts);

/// Lights pixels whose surfaces OpenGL has drawn, each once, however many small triangles share it.
/// OpenGL without a graphics card takes three times as long.
class SurfaceLighter {
 public:
  /// The references have to outlive this.
  /// @param intrinsics  of the picture
  /// @param nothing  the light where no surface is
  SurfaceLighter(const SurfaceShading& shading, const std::vector<PartLight>& parts,
                 const Intrinsics& intrinsics, const Eigen::Vector3f& nothing);

  /// @param place  of the images in the picture
  /// @param regions  of the picture, within `place`, around the pixels that are wanted
  /// @param wanted  CV_8UC1 of `place`: not 0 for these; what others hold is not sure
  /// @return CV_16UC4 of `place`: red, green, blue, 1, linear, numbers of 16 bits
  [[nodiscard]] cv::Mat light(const GeometryImages& geometry, const SurfaceImages& surfaces,
                              const cv::Rect& place, const std::vector<cv::Rect>& regions,
                              const cv::Mat& wanted) const;

 private:
  struct Row;

  void lightFour(const Row& row, int column, float u) const;
  [[nodiscard]] SurfaceLanes surfacesAt(const Row& row, int column, float u) const;

  const SurfaceShading& shading_;
  const std::vector<PartLight>& parts_;
  Intrinsics intrinsics_;
  Eigen::Vector3f nothing_;
};

}  // namespace synthetic_dataset::render
