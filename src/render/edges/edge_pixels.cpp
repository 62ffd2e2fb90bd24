#include "render/edges/edge_pixels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

#include <opencv2/core.hpp>

#include "render/pixels/lane_images.h"

namespace synthetic_dataset::render {
namespace {

/// What the centres of a row's pixels see, as a structure of arrays, padded so that four can be
/// loaded from any pixel on.
class SurfaceRow {
 public:
  /// @param most  the maximum number of pixels
  explicit SurfaceRow(int most) : items_(static_cast<std::size_t>(most + kLaneCount)) {
    for (auto* numbers : {&x_, &y_, &z_, &normal_x_, &normal_y_, &normal_z_}) {
      numbers->resize(items_.size());
    }
  }

  /// @param first  the first pixel, in the coordinates of `place`
  void take(const GeometryImages& images, const cv::Point& first, int width, const cv::Rect& place,
            const Intrinsics& k) {
    takeNormals(images, first, width);
    const float* depths = images.depth.ptr<float>(first.y, first.x);
    // Computed from the picture's columns, so that a pixel's place does not depend on the region.
    const Lanes centre = lanes(static_cast<float>(k.cx));
    const Lanes step = lanes(static_cast<float>(1.0 / k.fx));
    const Lanes slope_y = lanes(static_cast<float>((place.y + first.y - k.cy) / k.fy));
    std::array<float, kLaneCount> depth_room;
    for (int u = 0; u < width_; u += kLaneCount) {
      const int left = width_ - u;
      const Lanes depth = cv::v_load(atLeast(depths + u, left, depth_room));
      const Lanes column =
          lanes(static_cast<float>(place.x + first.x + u)) + Lanes(0.0F, 1.0F, 2.0F, 3.0F);
      cv::v_store(&x_[at(u)], (column - centre) * step * depth);
      cv::v_store(&y_[at(u)], slope_y * depth);
      cv::v_store(&z_[at(u)], depth);
    }
  }

  /// Like the other take(), for depths along the pixels' rays.
  /// @param rays  CV_32FC3, of the picture
  void take(const GeometryImages& images, const cv::Point& first, int width, const cv::Rect& place,
            const cv::Mat& rays) {
    takeNormals(images, first, width);
    distances_.resize(items_.size());
    const float* distances = images.depth.ptr<float>(first.y, first.x);
    const auto* along = rays.ptr<cv::Vec3f>(place.y + first.y, place.x + first.x);
    for (std::size_t u = 0; u < static_cast<std::size_t>(width_); ++u) {
      distances_[u] = distances[u];
      x_[u] = along[u][0] * distances[u];
      y_[u] = along[u][1] * distances[u];
      z_[u] = along[u][2] * distances[u];
    }
  }

  [[nodiscard]] int width() const { return width_; }

  // The values of four pixels:
  [[nodiscard]] cv::v_int32x4 items(int u) const { return cv::v_load(&items_[at(u)]); }
  [[nodiscard]] Lanes depths(int u) const {
    return cv::v_load(distances_.empty() ? &z_[at(u)] : &distances_[at(u)]);
  }
  [[nodiscard]] Lanes3 places(int u) const { return load(x_, y_, z_, u); }  ///< optical frame [m]
  [[nodiscard]] Lanes3 normals(int u) const { return load(normal_x_, normal_y_, normal_z_, u); }

 private:
  static std::size_t at(int u) { return static_cast<std::size_t>(u); }

  void takeNormals(const GeometryImages& images, const cv::Point& first, int width) {
    width_ = width;
    std::copy_n(images.items.ptr<int>(first.y, first.x), width_, items_.begin());
    const auto* normals = images.normals.ptr<std::uint16_t>(first.y, first.x);
    std::array<std::uint16_t, std::size_t{4} * kLaneCount> room;
    for (int u = 0; u < width_; u += kLaneCount) {
      const Lanes3 normal = loadHalves(atLeast(normals + 4 * u, 4 * (width_ - u), room)).xyz;
      cv::v_store(&normal_x_[at(u)], normal.x);
      cv::v_store(&normal_y_[at(u)], normal.y);
      cv::v_store(&normal_z_[at(u)], normal.z);
    }
  }

  static Lanes3 load(const std::vector<float>& x, const std::vector<float>& y,
                     const std::vector<float>& z, int u) {
    return {cv::v_load(&x[at(u)]), cv::v_load(&y[at(u)]), cv::v_load(&z[at(u)])};
  }

  int width_ = 0;
  std::vector<int> items_;
  std::vector<float> x_, y_, z_;
  std::vector<float> distances_;  // empty if depths are z
  std::vector<float> normal_x_, normal_y_, normal_z_;
};

/// Compares four pixels with four others; a bit is set for each pair that sees different surfaces.
int differing(const SurfaceRow& row, int u, const SurfaceRow& other, int o, float focal_length) {
  constexpr float kBend = 0.97F;  // the cosine of an angle beyond which shading may jump
  constexpr float kStep = 3.0F;   // [px] that one is in front of or behind the other's plane
  const Lanes3 normals = row.normals(u);
  const Lanes bends = dot(normals, other.normals(o)) < lanes(kBend);
  const Lanes off = dot(normals, other.places(o) - row.places(u));
  const Lanes steps = cv::v_abs(off) * lanes(focal_length) > lanes(kStep) * row.depths(u);
  const cv::v_int32x4 items = row.items(u);
  const cv::v_int32x4 is_item = items != cv::v_setzero_s32();
  const cv::v_int32x4 is_other = items != other.items(o);
  return cv::v_signmask(is_other | (cv::v_reinterpret_as_s32(bends | steps) & is_item));
}

/// Marks both pixels of each pair of neighbours that see different surfaces: one in a row, the
/// other in another row, or `shift` farther in the same row.
void mark(const SurfaceRow& row, const SurfaceRow& other, int shift, float focal_length,
          std::uint8_t* edges, std::uint8_t* other_edges) {
  const int count = row.width() - shift;
  for (int u = 0; u < count; u += kLaneCount) {
    const int bits = differing(row, u, other, u + shift, focal_length);
    if (bits == 0) continue;
    for (int i = 0; i < std::min(kLaneCount, count - u); ++i) {
      const auto differs = static_cast<std::uint8_t>(bits >> i & 1);
      edges[u + i] |= differs;
      other_edges[u + shift + i] |= differs;
    }
  }
}

/// Marks the edge pixels of a region, as far as neighbours inside the region tell.
/// @param region  in the coordinates of `place`
/// @param rows  buffers for as many pixels as `place` is wide
void markEdges(const GeometryImages& images, const cv::Rect& place, const cv::Rect& region,
               const Intrinsics& k, const cv::Mat& rays, std::array<SurfaceRow, 2>& rows,
               cv::Mat& edges) {
  const auto focal_length = static_cast<float>(k.fx);
  auto& [row, above] = rows;
  for (int v = region.y; v < region.y + region.height; ++v) {
    std::swap(row, above);
    if (rays.empty()) {
      row.take(images, {region.x, v}, region.width, place, k);
    } else {
      row.take(images, {region.x, v}, region.width, place, rays);
    }
    auto* here = edges.ptr<std::uint8_t>(v, region.x);
    mark(row, row, 1, focal_length, here, here);
    if (v > region.y) {
      mark(row, above, 0, focal_length, here, edges.ptr<std::uint8_t>(v - 1, region.x));
    }
  }
}

}  // namespace

EdgePixels::EdgePixels(const GeometryImages& images, const cv::Rect& place,
                       const std::vector<cv::Rect>& regions, const cv::Mat& wanted,
                       const Intrinsics& intrinsics, const cv::Mat& rays)
    : place_(place), row_words_((place.width + kWordBits - 1) / kWordBits) {
  cv::Mat edges = cv::Mat::zeros(place.height, row_words_ * kWordBits, CV_8UC1);
  cv::Mat counted = edges.clone();
  const cv::Rect all(cv::Point(), place.size());
  std::array<SurfaceRow, 2> rows = {SurfaceRow(place.width), SurfaceRow(place.width)};
  for (const cv::Rect& region : regions) {
    const cv::Rect here = region - place.tl();
    wanted(region).copyTo(counted(here));
    const cv::Rect around(here.x - 1, here.y - 1, here.width + 2, here.height + 2);
    markEdges(images, place, around & all, intrinsics, rays, rows, edges);
  }
  edges &= counted;
  words_.reserve(static_cast<std::size_t>(place.height * row_words_));
  for (int row = 0; row < place.height; ++row) {
    const auto* is_edge = edges.ptr<std::uint8_t>(row);
    for (int u = 0; u < edges.cols; u += kWordBits) {
      addWord(is_edge + u, {place.x + u, place.y + row});
    }
  }
}

/// Tests eight pixels at once, as most are not at an edge.
void EdgePixels::addWord(const std::uint8_t* is_edge, const cv::Point& first) {
  constexpr int kAtOnce = 8;
  Word word{0, pixels_.size()};
  for (int u = 0; u < kWordBits; u += kAtOnce) {
    std::uint64_t any = 0;
    static_assert(sizeof any == kAtOnce);
    std::memcpy(&any, is_edge + u, sizeof any);
    for (int i = u; any != 0 && i < u + kAtOnce; ++i) {
      if (is_edge[i] == 0) continue;
      word.bits |= std::uint64_t{1} << i;
      pixels_.emplace_back(first.x + i, first.y);
    }
  }
  words_.push_back(word);
}

cv::Mat EdgePixels::mask(const cv::Size& size) const {
  cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
  for (const cv::Point& pixel : pixels_) mask.at<std::uint8_t>(pixel) = 255;
  return mask;
}

}  // namespace synthetic_dataset::render
