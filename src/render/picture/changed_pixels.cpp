#include "render/picture/changed_pixels.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "render/pixels/lane_images.h"

namespace synthetic_dataset::render {
namespace {

/// The places of four pixels in a shadow map [texel]; below 0 behind the light.
struct FourInMap {
  Lanes columns, rows;
};

FourInMap divided(const Lanes& columns, const Lanes& rows, const Lanes& w) {
  const Lanes is_before = w > lanes(0.0F);
  const Lanes behind = lanes(-1.0F);
  return {cv::v_select(is_before, columns / w, behind), cv::v_select(is_before, rows / w, behind)};
}

/// The places of four points in a map.
/// @param from_camera  to w times column, w times row, (unused,) w
FourInMap findInMap(const Eigen::Matrix4f& from_camera, const Lanes3& p_C) {
  const auto times = [&](int row) {
    return dot(lanes(Eigen::Vector3f(from_camera.block<1, 3>(row, 0))), p_C) +
           lanes(from_camera(row, 3));
  };
  return divided(times(0), times(1), times(3));
}

/// Finds the places of a row's pixels in a shadow map.
class RowInMap {
 public:
  /// @param from_pixel  from (u, v, 1) times depth, and 1, to w times column, w times row,
  ///   (unused,) w
  RowInMap(const Eigen::Matrix4f& from_pixel, int v)
      : from_pixel_(from_pixel),
        across_(from_pixel.col(1) * static_cast<float>(v) + from_pixel.col(2)) {}

  /// @param first  the first pixel's column in the picture
  [[nodiscard]] FourInMap find(int first, const Lanes& depth) const {
    const Lanes u = lanes(static_cast<float>(first)) + Lanes(0.0F, 1.0F, 2.0F, 3.0F);
    return divided(times(0, u, depth), times(1, u, depth), times(3, u, depth));
  }

 private:
  [[nodiscard]] Lanes times(int row, const Lanes& u, const Lanes& depth) const {
    return (lanes(from_pixel_(row, 0)) * u + lanes(across_[row])) * depth +
           lanes(from_pixel_(row, 3));
  }

  Eigen::Matrix4f from_pixel_;
  Eigen::Vector4f across_;
};

}  // namespace

cv::Mat ChangedPixels::find(const PossibleChanges& regions, const SeenGeometry& seen,
                            const std::vector<ChangedTexels>& texels, const cv::Mat& edges) const {
  cv::Mat pixels = regions.glass.clone();
  markMoving(seen, pixels);
  if (!seen.reaches.empty()) markNear(seen, pixels);
  for (const ChangedTexels& each : texels) markShaded(regions.shadows, seen, each, pixels);
  return withEdges(pixels, regions, edges);
}

cv::Mat ChangedPixels::withEdges(const cv::Mat& pixels, const PossibleChanges& regions,
                                 const cv::Mat& edges) {
  if (edges.empty()) return pixels;
  // Pixels at an edge take light from those around them,
  cv::Mat grown;
  cv::dilate(pixels, grown, cv::Mat());  // by one pixel
  // and what moves may cover a part of one whose centre it does not cover.
  return grown | (edges & regions.surfaces);
}

void ChangedPixels::markMoving(const SeenGeometry& seen, cv::Mat& pixels) const {
  std::vector<std::uint8_t> moves = {0};
  for (const DrawItem& item : draw_list_.items()) moves.push_back(item.stands_still ? 0 : 255);
  for (int row = 0; row < seen.place.height; ++row) {
    const int* items = seen.images.items.ptr<int>(row);
    auto* marked = pixels.ptr<std::uint8_t>(seen.place.y + row, seen.place.x);
    for (int column = 0; column < seen.place.width; ++column) {
      if (moves[static_cast<std::size_t>(items[column])] != 0) marked[column] = 255;
    }
  }
}

/// Marks the pixels near marked ones.
void ChangedPixels::markNear(const SeenGeometry& seen, cv::Mat& pixels) {
  cv::Mat marked = pixels(seen.place);
  cv::Mat distances;
  cv::distanceTransform(marked == 0, distances, cv::DIST_C, 3);
  marked.setTo(255, distances <= seen.reaches);
}

/// @param candidates  the pixels to test
void ChangedPixels::markShaded(const cv::Mat& candidates, const SeenGeometry& seen,
                               const ChangedTexels& texels, cv::Mat& pixels) const {
  if (texels.place.empty()) return;
  const Intrinsics& k = view_.camera.intrinsics();
  Eigen::Matrix4d camera_from_pixel = Eigen::Matrix4d::Identity();
  camera_from_pixel.topLeftCorner<2, 3>() << 1.0 / k.fx, 0.0, -k.cx / k.fx,  //
      0.0, 1.0 / k.fy, -k.cy / k.fy;
  const Eigen::Matrix4d from_camera = texels.texels_from_world * view_.X_WC.matrix();
  const Eigen::Matrix4f from_pixel = (from_camera * camera_from_pixel).cast<float>();
  const Eigen::Matrix4f from_point = from_camera.cast<float>();
  for (int row = 0; row < seen.place.height; ++row) {
    const int v = seen.place.y + row;
    const int* items = seen.images.items.ptr<int>(row);
    const float* depths = seen.images.depth.ptr<float>(row);
    const auto* is_candidate = candidates.ptr<std::uint8_t>(v, seen.place.x);
    auto* marked = pixels.ptr<std::uint8_t>(v, seen.place.x);
    const RowInMap row_in_map(from_pixel, v);
    std::array<float, kLaneCount> room;
    std::array<float, std::size_t{3} * kLaneCount> ray_room;
    for (int column = 0; column < seen.place.width; column += kLaneCount) {
      const int count = std::min(kLaneCount, seen.place.width - column);
      int open = 0;  // a bit for each pixel whose shadow may have changed
      for (int i = 0; i < count; ++i) {
        const int u = column + i;
        const bool is_open = is_candidate[u] != 0 && marked[u] == 0 && items[u] != 0;
        open |= static_cast<int>(is_open) << i;
      }
      if (open == 0) continue;
      const Lanes depth = cv::v_load(atLeast(depths + column, count, room));
      const auto find = [&] {
        if (seen.rays.empty()) return row_in_map.find(seen.place.x + column, depth);
        Lanes3 ray;
        const float* rays = seen.rays.ptr<float>(v, seen.place.x + column);
        cv::v_load_deinterleave(atLeast(rays, 3 * count, ray_room), ray.x, ray.y, ray.z);
        return findInMap(from_point, ray * depth);
      };
      const FourInMap four = find();
      const int changed = texels.changed(four.columns, four.rows, open);
      for (int i = 0; changed != 0 && i < count; ++i) {
        if ((changed >> i & 1) != 0) marked[column + i] = 255;
      }
    }
  }
}

}  // namespace synthetic_dataset::render
