#include "render/labels/label_painter.h"

#include <algorithm>
#include <cstdint>

#include "render/labels/lens_labels.h"
#include "render/parts/surface_drawing.h"
#include "render/shaders.h"

namespace synthetic_dataset::render {
namespace {

/// Distances from the camera's centre, from depths along its axis.
cv::Mat rangeOf(const cv::Mat& depth, const Intrinsics& k) {
  cv::Mat range(depth.size(), CV_32FC1);
  // By rows, so that many pixels are worked out at a time.
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
    // By pointers: cv::Mat's iterators look for the ends of rows at each pixel.
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
                                       const LinkSelection& drawn, const LabelPlanes& planes) {
  const cv::Size size(view.camera.width(), view.camera.height());
  const LabelTarget& target = targetFor(size, planes);
  target.begin(size);
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
  // As geometry is drawn, so that of surfaces at the same place the same one is seen.
  const Pose X_CW = view.X_WC.inverse();
  draw(draw_list_.solidItems(X_CW, X_WL, drawn, true), GL_GEQUAL);
  draw(draw_list_.solidItems(X_CW, X_WL, drawn, false), GL_GREATER);
  draw(draw_list_.transparentItems(X_CW, X_WL, drawn), GL_GREATER);
  return target.read(size);
}

/// Drawn into as it is, or made anew where it is too small: pictures are of many sizes.
const LabelTarget& LabelPainter::targetFor(const cv::Size& size, const LabelPlanes& planes) {
  std::optional<LabelTarget>& target = targets_[planes];
  if (!target || target->width() < size.width || target->height() < size.height) {
    const cv::Size held = target ? cv::Size(target->width(), target->height()) : cv::Size();
    target.reset();
    target.emplace(gl_, std::max(size.width, held.width), std::max(size.height, held.height),
                   planes);
  }
  return *target;
}

LabelImages LabelPainter::paint(const View& view, const std::vector<Pose>& X_WL,
                                const LabelPass& pass) {
  if (hasDistortion(view.camera)) {
    return labelsOf(*eye_.look(view, X_WL, pass.drawn, Glass::kSeen), draw_list_, pass);
  }
  LabelPlanes planes;
  planes.links = pass.links;
  planes.normals = pass.normals;
  LabelImages images = paintPinhole(view, X_WL, pass.drawn, planes);
  if (pass.range) images.range = rangeOf(images.depth, view.camera.intrinsics());
  return images;
}

}  // namespace synthetic_dataset::render
