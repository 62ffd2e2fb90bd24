#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "render/geometry/geometry_images.h"
#include "render/light/arriving_lights.h"
#include "render/light/classic_shading.h"
#include "render/light/surface_shading.h"
#include "render/parts/draw_list.h"
#include "render/parts/item_surface.h"

namespace synthetic_dataset::render {

/// The lighting properties of all items, indexed by their numbers in GeometryImages.
[[nodiscard]] std::vector<ItemLight> itemLights(const std::vector<DrawItem>& items,
                                                world::Simulator simulator);

/// Lights pixels whose surfaces OpenGL has drawn, each pixel once, however many small triangles are
/// in it. OpenGL on the CPU takes three times as long.
class SurfaceLighter {
 public:
  /// The references have to outlive this.
  /// @param intrinsics  of the picture
  /// @param nothing  the light where there is no surface
  /// @param rays  CV_32FC3, of the picture: the pixels' rays, along which depths are measured;
  ///   empty for a pinhole camera
  SurfaceLighter(const LightingContext& context, const std::vector<ItemLight>& items,
                 const Intrinsics& intrinsics, const Eigen::Vector3f& nothing,
                 const cv::Mat& rays = {});

  /// @param place  of the images in the picture
  /// @param regions  of the picture, within `place`; contain all wanted pixels
  /// @param wanted  CV_8UC1 of `place`: not 0 for the wanted pixels; all others are undefined
  /// @param open  CV_32FC1 of `place`: the share of the ambient light that arrives; empty if all of
  ///   it does
  /// @return CV_16UC4 of `place`: red, green, blue, 1, as half floats: exposed and linear, or in
  ///   Gazebo Classic's worlds encoded and not exposed
  [[nodiscard]] cv::Mat light(const GeometryImages& geometry, const SurfaceImages& surfaces,
                              const cv::Rect& place, const std::vector<cv::Rect>& regions,
                              const cv::Mat& wanted, const cv::Mat& open = {}) const;

 private:
  struct Row;

  void lightFour(const Row& row, int column, float u, const std::vector<std::size_t>& lights) const;
  [[nodiscard]] const ArrivingLights& arriving() const;
  void findReaching(const Row& row, const cv::Range& columns, int left,
                    std::vector<std::size_t>& lights) const;
  [[nodiscard]] SurfaceLanes surfacesAt(const Row& row, int column, float u) const;
  [[nodiscard]] ClassicLanes classicAt(const Row& row, int column, float u) const;
  [[nodiscard]] Lanes3 positionsAt(const Row& row, int column, float u) const;

  std::optional<SurfaceShading> shading_;
  std::optional<ClassicShading> classic_;  ///< instead of shading_ in Gazebo Classic's worlds
  const std::vector<ItemLight>& items_;
  Intrinsics intrinsics_;
  Eigen::Vector3f nothing_;
  cv::Mat rays_;
};

}  // namespace synthetic_dataset::render
