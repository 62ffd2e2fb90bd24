#include "render/picture/changed_pixels.h"

#include <cstdint>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::render {

cv::Mat ChangedPixels::find(const PossibleChanges& regions, const SeenGeometry& seen,
                            const std::vector<ChangedTexels>& texels, const cv::Mat& edges) const {
  cv::Mat pixels = regions.glass.clone();
  markMoving(seen, pixels);
  for (const ChangedTexels& each : texels) markShaded(regions.shadows, seen, each, pixels);
  if (edges.empty()) return pixels;
  // Pixels by an edge take light from those round them,
  cv::Mat grown;
  cv::dilate(pixels, grown, cv::Mat());  // by one
  // and what moves may cover a part of one whose centre it does not cover.
  return grown | (edges & regions.surfaces);
}

void ChangedPixels::markMoving(const SeenGeometry& seen, cv::Mat& pixels) const {
  std::vector<std::uint8_t> moves = {0};
  for (const Part& part : parts_.parts()) moves.push_back(part.stands_still ? 0 : 255);
  for (int row = 0; row < seen.place.height; ++row) {
    const int* parts = seen.images.parts.ptr<int>(row);
    auto* marked = pixels.ptr<std::uint8_t>(seen.place.y + row, seen.place.x);
    for (int column = 0; column < seen.place.width; ++column) {
      marked[column] |= moves[static_cast<std::size_t>(parts[column])];
    }
  }
}

/// @param candidates  the pixels that are looked at
void ChangedPixels::markShaded(const cv::Mat& candidates, const SeenGeometry& seen,
                               const ChangedTexels& texels, cv::Mat& pixels) const {
  if (texels.place.empty()) return;
  const Intrinsics& k = view_.camera.intrinsics();
  // From (u, v, 1) times depth, and 1, to columns and rows of the map, times w.
  Eigen::Matrix4d camera_from_pixel = Eigen::Matrix4d::Identity();
  camera_from_pixel.topLeftCorner<2, 3>() << 1.0 / k.fx, 0.0, -k.cx / k.fx,  //
      0.0, 1.0 / k.fy, -k.cy / k.fy;
  const Eigen::Matrix4f from_pixel =
      (texels.texels_from_world * view_.X_WC.matrix() * camera_from_pixel).cast<float>();
  const Eigen::Vector4f along_u = from_pixel.col(0);
  for (int row = 0; row < seen.place.height; ++row) {
    const int v = seen.place.y + row;
    const int* parts = seen.images.parts.ptr<int>(row);
    const float* depths = seen.images.depth.ptr<float>(row);
    const auto* is_candidate = candidates.ptr<std::uint8_t>(v, seen.place.x);
    auto* marked = pixels.ptr<std::uint8_t>(v, seen.place.x);
    const Eigen::Vector4f across = from_pixel.col(1) * static_cast<float>(v) + from_pixel.col(2);
    for (int column = 0; column < seen.place.width; ++column) {
      if (is_candidate[column] == 0 || marked[column] != 0 || parts[column] == 0) continue;
      const auto u = static_cast<float>(seen.place.x + column);
      const Eigen::Vector4f place = (along_u * u + across) * depths[column] + from_pixel.col(3);
      if (place.w() > 0.0F && texels.isChanged(place.x() / place.w(), place.y() / place.w())) {
        marked[column] = 255;
      }
    }
  }
}

}  // namespace synthetic_dataset::render
