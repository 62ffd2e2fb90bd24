#include "render/edges/edge_pixels.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include <opencv2/core.hpp>

#include "render/pixels/half.h"

namespace synthetic_dataset::render {
namespace {

/// What the centres of a row's pixels see, member by member, for loops over many at a time.
struct SurfaceRow {
  explicit SurfaceRow(std::size_t width)
      : part(width),
        x(width),
        y(width),
        z(width),
        normal_x(width),
        normal_y(width),
        normal_z(width) {}

  /// @param first  the first pixel, in the coordinates of `place`
  void take(const GeometryImages& images, const cv::Point& first, const cv::Rect& place,
            const Intrinsics& k) {
    const int* parts = images.parts.ptr<int>(first.y, first.x);
    const float* depths = images.depth.ptr<float>(first.y, first.x);
    const auto* normals = images.normals.ptr<std::uint16_t>(first.y, first.x);
    // From the picture's own columns, so that a pixel's place does not depend on the region.
    const auto centre = static_cast<float>(k.cx);
    const auto step = static_cast<float>(1.0 / k.fx);
    const auto slope_y = static_cast<float>((place.y + first.y - k.cy) / k.fy);
    const int column = place.x + first.x;
    for (std::size_t u = 0; u < part.size(); ++u) {
      part[u] = parts[u];
      z[u] = depths[u];
      x[u] = (static_cast<float>(column + static_cast<int>(u)) - centre) * step * z[u];
      y[u] = slope_y * z[u];
      normal_x[u] = fromHalf(normals[4 * u]);
      normal_y[u] = fromHalf(normals[4 * u + 1]);
      normal_z[u] = fromHalf(normals[4 * u + 2]);
    }
  }

  std::vector<int> part;
  std::vector<float> x, y, z;  ///< in the optical frame [m]
  std::vector<float> normal_x, normal_y, normal_z;
};

/// Marks pixels of a row and their neighbours in another, or `shift` farther in the same row, where
/// they see different surfaces.
void mark(const SurfaceRow& row, const SurfaceRow& other, std::size_t shift, float focal_length,
          std::uint8_t* edges, std::uint8_t* other_edges) {
  constexpr float kBend = 0.97F;  // the cosine of an angle beyond which shading may jump
  constexpr float kStep = 3.0F;   // [px] that one is before or behind the plane of the other
  for (std::size_t u = 0; u + shift < row.part.size(); ++u) {
    const std::size_t o = u + shift;
    const float cosine = row.normal_x[u] * other.normal_x[o] + row.normal_y[u] * other.normal_y[o] +
                         row.normal_z[u] * other.normal_z[o];
    const float off = row.normal_x[u] * (other.x[o] - row.x[u]) +
                      row.normal_y[u] * (other.y[o] - row.y[u]) +
                      row.normal_z[u] * (other.z[o] - row.z[u]);
    // Without jumps: bits instead of logic.
    const int bends = cosine < kBend ? 1 : 0;
    const int steps = std::abs(off) * focal_length > kStep * row.z[u] ? 1 : 0;
    const int is_part = row.part[u] != 0 ? 1 : 0;
    const int is_other = row.part[u] != other.part[o] ? 1 : 0;
    const auto differs = static_cast<std::uint8_t>(is_other | ((bends | steps) & is_part));
    edges[u] |= differs;
    other_edges[o] |= differs;
  }
}

/// Marks the pixels of a region that are by an edge, and some of those round it.
/// @param region  in the coordinates of `place`
void markEdges(const GeometryImages& images, const cv::Rect& place, const cv::Rect& region,
               const Intrinsics& k, cv::Mat& edges) {
  const auto focal_length = static_cast<float>(k.fx);
  SurfaceRow row(static_cast<std::size_t>(region.width));
  SurfaceRow above = row;
  for (int v = region.y; v < region.y + region.height; ++v) {
    std::swap(row, above);
    row.take(images, {region.x, v}, place, k);
    auto* here = edges.ptr<std::uint8_t>(v, region.x);
    mark(row, row, 1, focal_length, here, here);
    if (v > region.y) {
      mark(row, above, 0, focal_length, here, edges.ptr<std::uint8_t>(v - 1, region.x));
    }
  }
}

}  // namespace

EdgePixels::EdgePixels(const GeometryImages& images, const cv::Rect& place,
                       const std::vector<cv::Rect>& regions, const Intrinsics& intrinsics)
    : place_(place), blocks_(place.height, (place.width + kBlock - 1) / kBlock, CV_32SC1) {
  cv::Mat edges = cv::Mat::zeros(place.size(), CV_8UC1);
  cv::Mat wanted = edges.clone();
  const cv::Rect all(cv::Point(), place.size());
  for (const cv::Rect& region : regions) {
    const cv::Rect here = region - place.tl();
    wanted(here).setTo(1);
    const cv::Rect around(here.x - 1, here.y - 1, here.width + 2, here.height + 2);
    markEdges(images, place, around & all, intrinsics, edges);
  }
  edges &= wanted;
  rows_.push_back(0);
  for (int row = 0; row < place.height; ++row) {
    const auto* is_edge = edges.ptr<std::uint8_t>(row);
    int* block = blocks_.ptr<int>(row);
    for (int column = 0; column < place.width; ++column) {
      if (column % kBlock == 0) block[column / kBlock] = static_cast<int>(pixels_.size());
      if (is_edge[column] != 0) pixels_.emplace_back(place.x + column, place.y + row);
    }
    rows_.push_back(static_cast<int>(pixels_.size()));
  }
}

cv::Mat EdgePixels::mask(const cv::Size& size) const {
  cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
  for (const cv::Point& pixel : pixels_) mask.at<std::uint8_t>(pixel) = 255;
  return mask;
}

}  // namespace synthetic_dataset::render
