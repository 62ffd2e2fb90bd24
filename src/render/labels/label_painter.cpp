#include "render/labels/label_painter.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <opencv2/core.hpp>

#include "render/lens/lens_sight.h"
#include "render/parts/surface_drawing.h"
#include "render/shaders.h"

namespace synthetic_dataset::render {
namespace {

/// The label shader's outputs.
enum LabelOutput : std::size_t { kIds, kDepths, kLinks, kNormals };

/// The interpolated normal, turned towards the camera. The vertices' normals may point into the
/// body or, near the silhouette of a round body, slightly away from the camera: the triangle
/// determines which side is seen.
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
    const SeenTriangle& seen = sight.seen[static_cast<std::size_t>(triangles[i])];
    const Eigen::Vector3f normal = seenNormal(
        sight.triangleAt(triangles[i]), (*sight.surfaces)[static_cast<std::size_t>(seen.item)],
        sight.poseOf(seen).linear().cast<float>(), Eigen::Vector3f(rays[i].val));
    to[i] = {normal.x(), normal.y(), normal.z()};
  }
  return normals;
}

/// Labels from a view through a lens.
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

/// Distances from the camera's centre, from depths along its axis.
cv::Mat rangeOf(const cv::Mat& depth, const Intrinsics& k) {
  cv::Mat range(depth.size(), CV_32FC1);
  // Row by row, so that many pixels are computed at a time.
  const Eigen::ArrayXd x =
      (Eigen::ArrayXd::LinSpaced(depth.cols, 0.0, depth.cols - 1.0) - k.cx) / k.fx;
  const Eigen::ArrayXf xx = (x * x).cast<float>();
  for (int v = 0; v < depth.rows; ++v) {
    const double y = (v - k.cy) / k.fy;
    const Eigen::Map<const Eigen::ArrayXf> z(depth.ptr<float>(v), depth.cols);
    Eigen::Map<Eigen::ArrayXf>(range.ptr<float>(v), depth.cols) =
        z * (xx + static_cast<float>(y * y + 1.0)).sqrt();
  }
  return range;
}

}  // namespace

LabelImages labelsOf(const GeometryImages& images, const DrawList& draw_list,
                     const Intrinsics& intrinsics, const LabelPass& pass) {
  std::vector<int> identifiers = {0};
  std::vector<int> links = {0};
  for (const DrawItem& item : draw_list.items()) {
    identifiers.push_back(static_cast<int>(item.identifier));
    links.push_back(static_cast<int>(item.link) + 1);
  }
  const auto translated = [&](const std::vector<int>& table) {
    cv::Mat result(images.items.size(), CV_32SC1);
    // With pointers, as cv::Mat's iterators check for the end of a row at each pixel.
    const int* items_seen = images.items.ptr<int>();
    std::transform(items_seen, items_seen + images.items.total(), result.ptr<int>(),
                   [&](int item) { return table[static_cast<std::size_t>(item)]; });
    return result;
  };
  LabelImages labels;
  labels.ids = translated(identifiers);
  labels.depth = images.depth;
  if (pass.links) labels.links = translated(links);
  if (pass.range) labels.range = rangeOf(labels.depth, intrinsics);
  return labels;
}

LabelPainter::LabelPainter(const GlFunctions& gl, const DrawList& draw_list, LensEye& eye)
    : gl_(gl),
      draw_list_(draw_list),
      eye_(eye),
      programs_(gl, shaders::kMeshVertex, shaders::kLabelFragment,
                feature::kHoles | feature::kNearLimit) {}

LabelImages LabelPainter::paintPinhole(const View& view, const std::vector<Pose>& X_WL,
                                       const LabelPass& pass) {
  const cv::Size size(view.camera.width(), view.camera.height());
  const cv::Rect all(cv::Point(), size);
  const Framebuffer& target = targetFor(size, pass);
  target.bind(size, all);
  target.clearToZero(kIds);
  target.clear(kDepths, {});
  target.clearToZero(kLinks);
  target.clear(kNormals, {});
  target.clearDepth();
  const auto draw = [&](const std::vector<const DrawItem*>& items, GLenum depth_func) {
    gl_.DepthFunc(depth_func);
    for (const DrawItem* item : items) {
      if (item->seen_through_in_labels) continue;
      const ShaderProgram& program = programs_.get(item->features | featuresOf(view));
      program.set("identifier", item->identifier);
      program.set("link", static_cast<std::uint32_t>(item->link + 1));
      drawSurface(gl_, program, *item, view, X_WL[item->link]);
    }
  };
  // In the order in which geometry is drawn, so that the same one of coincident surfaces is seen.
  const Pose X_CW = view.X_WC.inverse();
  draw(draw_list_.solidItems(X_CW, X_WL, pass.drawn, true), GL_GEQUAL);
  draw(draw_list_.solidItems(X_CW, X_WL, pass.drawn, false), GL_GREATER);
  draw(draw_list_.transparentItems(X_CW, X_WL, pass.drawn), GL_GREATER);
  LabelImages images;
  images.ids = target.read(kIds, all);
  images.depth = target.read(kDepths, all);
  images.links = target.read(kLinks, all);
  images.normals = target.read(kNormals, all);
  return images;
}

const Framebuffer& LabelPainter::targetFor(const cv::Size& size, const LabelPass& pass) {
  std::optional<Framebuffer>& target = targets_[{pass.links, pass.normals}];
  const GLenum links = pass.links ? GL_R32UI : GL_NONE;
  const GLenum normals = pass.normals ? GL_RGBA32F : GL_NONE;
  return framebufferFor(gl_, size, {GL_R32UI, GL_R32F, links, normals}, GL_DEPTH_COMPONENT32F,
                        target);
}

LabelImages LabelPainter::paint(const View& view, const std::vector<Pose>& X_WL,
                                const LabelPass& pass) {
  if (hasDistortion(view.camera)) {
    return labelsOf(*eye_.look(view, X_WL, pass.drawn, Glass::kSeen), draw_list_, pass);
  }
  LabelImages images = paintPinhole(view, X_WL, pass);
  if (pass.range) images.range = rangeOf(images.depth, view.camera.intrinsics());
  return images;
}

LabelImages LabelPainter::paint(const RollingView& rows, const LabelPass& pass) {
  return labelsOf(*eye_.look(rows, pass.drawn, Glass::kSeen), draw_list_, pass);
}

}  // namespace synthetic_dataset::render
