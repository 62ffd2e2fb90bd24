#include "render/labels/lens_labels.h"

#include <algorithm>
#include <cstddef>

#include <opencv2/core.hpp>

namespace synthetic_dataset::render {
namespace {

/// Towards the camera. The vertices' normals may point into the body, or, by the silhouette of a
/// round one, a little away from the camera: the triangle says which side is seen.
Eigen::Vector3f seenNormal(const FacedTriangle& triangle, const ItemSurface& surface,
                           const Eigen::Matrix3f& R_CV, const Eigen::Vector3f& ray) {
  const Eigen::Vector3f weights = triangle.weights(ray);
  const Eigen::Vector3f shares = weights / weights.sum();
  const auto& corners = triangle.corners();
  const Eigen::Vector3f to_camera = -ray;
  Eigen::Vector3f flat = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  if (flat.dot(to_camera) < 0.0F) flat = -flat;
  Eigen::Vector3f normal = (R_CV * triangle.mixed(surface.shape->normals, shares)).normalized();
  if (normal.dot(flat) < 0.0F) normal = -normal;
  const float away = std::min(normal.dot(to_camera), 0.0F);
  return (normal - away * to_camera).normalized();
}

cv::Mat normalsOf(const LensSight& sight) {
  cv::Mat normals = cv::Mat::zeros(sight.items.size(), CV_32FC3);
  const int* triangles = sight.triangles.ptr<int>();
  const auto* rays = sight.lens->rays.ptr<cv::Vec3f>();
  auto* to = normals.ptr<cv::Vec3f>();
  for (std::size_t i = 0; i < sight.triangles.total(); ++i) {
    if (triangles[i] < 0) continue;
    const auto item =
        static_cast<std::size_t>(sight.seen[static_cast<std::size_t>(triangles[i])].item);
    const Eigen::Vector3f normal =
        seenNormal(sight.triangleAt(triangles[i]), (*sight.surfaces)[item],
                   sight.X_CV[item].linear().cast<float>(), Eigen::Vector3f(rays[i].val));
    to[i] = {normal.x(), normal.y(), normal.z()};
  }
  return normals;
}

}  // namespace

LabelImages labelsOf(const LensSight& sight, const DrawList& draw_list, const LabelPass& pass) {
  LabelImages labels =
      labelsOf({sight.items, sight.distance, {}}, draw_list, Intrinsics(), {{}, pass.links});
  cv::Mat along_axis;
  cv::extractChannel(sight.lens->rays, along_axis, 2);
  labels.depth = cv::Mat();  // the distances stay as they are
  cv::multiply(sight.distance, along_axis, labels.depth);
  if (pass.normals) labels.normals = normalsOf(sight);
  if (pass.range) labels.range = sight.distance;
  return labels;
}

}  // namespace synthetic_dataset::render
