#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

#include "render/lens/lens_map.h"
#include "render/lens/ray_raster.h"
#include "render/lens/row_poses.h"
#include "render/parts/item_surface.h"
#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {

/// A triangle of an item, in the viewer's frame.
class FacedTriangle {
 public:
  /// @param vertices  of the mesh
  FacedTriangle(const std::array<Eigen::Vector3f, 3>& corners,
                const std::array<std::uint32_t, 3>& vertices, const ItemSurface& surface)
      : corners_(corners),
        vertices_(vertices),
        surface_(&surface),
        sides_{corners[1].cross(corners[2]), corners[2].cross(corners[0]),
               corners[0].cross(corners[1])} {}

  [[nodiscard]] const std::array<Eigen::Vector3f, 3>& corners() const { return corners_; }

  /// The barycentric weights, up to their sum, of the point where a ray meets the triangle's plane;
  /// linear in the ray.
  [[nodiscard]] Eigen::Vector3f weights(const Eigen::Vector3f& ray) const {
    return {sides_[0].dot(ray), sides_[1].dot(ray), sides_[2].dot(ray)};
  }

  /// The vertices' values, interpolated.
  template <class Value>
  [[nodiscard]] Value mixed(const std::vector<Value>& values, const Eigen::Vector3f& shares) const {
    return shares[0] * values[vertices_[0]] + shares[1] * values[vertices_[1]] +
           shares[2] * values[vertices_[2]];
  }

  /// The vertices' colours, interpolated as in the shaders.
  [[nodiscard]] Eigen::Vector4f tint(const Eigen::Vector3f& shares) const {
    Eigen::Vector4f sum = Eigen::Vector4f::Zero();
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Eigen::Vector4f& given = (*surface_->tints)[vertices_[static_cast<std::size_t>(i)]];
      sum += shares[i] * (surface_->tints_are_encoded ? linearFromSrgb(given) : given);
    }
    return sum;
  }

  [[nodiscard]] bool hasCoordinates() const {
    return surface_->shape->texture_coordinates.size() == surface_->shape->positions.size();
  }

  /// The texture coordinates of a vertex.
  [[nodiscard]] Eigen::Vector2f coordinates(std::size_t vertex) const {
    if (!hasCoordinates()) return surface_->offset;
    const Eigen::Vector2f& given = surface_->shape->texture_coordinates[vertices_[vertex]];
    return given.cwiseProduct(surface_->scale) + surface_->offset;
  }

  /// A place on textures, and how it changes from pixel to pixel.
  struct TexturePlace {
    Eigen::Vector2f place, across, along;
  };

  /// @param across, along  the differences between the ray and those of the pixels to the right and
  ///   below
  [[nodiscard]] TexturePlace onTexture(const Eigen::Vector3f& ray, const Eigen::Vector3f& across,
                                       const Eigen::Vector3f& along) const {
    const Eigen::Vector3f here = weights(ray);
    const float sum = here.sum();
    Eigen::Matrix<float, 2, 3> of_corners;
    of_corners << coordinates(0), coordinates(1), coordinates(2);
    const Eigen::Vector2f place = of_corners * here / sum;
    const auto change = [&](const Eigen::Vector3f& step) -> Eigen::Vector2f {
      const Eigen::Vector3f there = weights(step);
      return (of_corners * there - there.sum() * place) / sum;
    };
    return {place, change(across), change(along)};
  }

 private:
  std::array<Eigen::Vector3f, 3> corners_;
  std::array<std::uint32_t, 3> vertices_;
  const ItemSurface* surface_;
  std::array<Eigen::Vector3f, 3> sides_;  ///< normals of the planes through the origin
};

/// What the ray of each of a lens's pixels sees.
struct LensSight {
  std::shared_ptr<const LensMap> lens;
  cv::Mat items;      ///< CV_32SC1: the draw list's number of the item that is seen, 0 for nothing
  cv::Mat triangles;  ///< CV_32SC1: the triangle's index in `seen`, -1 for nothing
  cv::Mat distance;   ///< CV_32FC1: along the ray [m], 0 for nothing
  std::vector<SeenTriangle> seen;
  std::vector<Pose> X_CV;  ///< of each item, by its number
  std::shared_ptr<const std::vector<ItemSurface>> surfaces;
  std::shared_ptr<const RowPoses> rows = nullptr;  ///< set if rows are taken one after the other

  /// X_CV of the triangle's item, at the time of its row if it has one.
  [[nodiscard]] Pose poseOf(const SeenTriangle& triangle) const;

  [[nodiscard]] std::array<Eigen::Vector3d, 3> cornersOf(const SeenTriangle& triangle) const;
  [[nodiscard]] FacedTriangle triangleAt(int index) const;
};

/// A function that says whether an item with holes has one where a ray meets it; textures are
/// looked up as for pictures of the lens's faces.
/// @param surfaces  by the items' numbers
[[nodiscard]] RayRaster::IsHole holesIn(
    const DrawList& draw_list, const std::shared_ptr<const std::vector<ItemSurface>>& surfaces);

/// The distance at which a ray meets the triangle's plane, in units of the ray's length.
[[nodiscard]] double distanceTo(const std::array<Eigen::Vector3d, 3>& corners,
                                const Eigen::Vector3d& ray);

}  // namespace synthetic_dataset::render
