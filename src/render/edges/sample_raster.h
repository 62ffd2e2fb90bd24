#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/types.hpp>

#include "render/edges/edge_pixels.h"
#include "render/parts/draw_list.h"
#include "render/pixels/lanes.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// The places in a pixel, besides its centre, that are sampled, relative to the centre [px]: each
/// in a row and a column of its own (a rotated grid).
inline constexpr std::size_t kSampleCount = kLaneCount;
inline constexpr std::array<float, kSampleCount> kSampleColumns = {-0.125F, 0.375F, -0.375F,
                                                                   0.125F};
inline constexpr std::array<float, kSampleCount> kSampleRows = {-0.375F, -0.125F, 0.125F, 0.375F};

/// A triangle that a sample sees.
struct SeenFace {
  int item = 0;                              ///< as in GeometryImages::items
  Eigen::Vector3f normal{0.0F, 0.0F, 0.0F};  ///< in the optical frame, towards the camera
  Eigen::Vector3f origin{0.0F, 0.0F, 0.0F};  ///< the farthest corner: u, v [px], 1 / depth [1/m]
  float nearest = 0.0F;                      ///< 1 / depth of the nearest corner
  Eigen::Vector2f slope{0.0F, 0.0F};         ///< of 1 / depth (linear over the image), per pixel
};

/// Finds what the samples of some pixels see, by drawing triangles at these places only.
class SampleRaster {
 public:
  /// @param edges  has to outlive this object
  SampleRaster(const View& view, const EdgePixels& edges, const cv::Mat& items,
               const cv::Rect& place);

  /// Draws an item; samples then see whatever is nearer, it or what was drawn before.
  /// @param number  as in GeometryImages::items
  void draw(const DrawItem& item, int number, const Pose& X_WL);

  /// The face that a sample of edges.pixels()[pixel] sees, or null.
  [[nodiscard]] const SeenFace* at(std::size_t pixel, std::size_t sample) const {
    const int face = samples_[pixel].face[sample];
    return face < 0 ? nullptr : &faces_[static_cast<std::size_t>(face)];
  }

 private:
  /// What each sample of a pixel sees.
  struct PixelSamples {
    std::array<float, kSampleCount> inverse_depth = {0.0F, 0.0F, 0.0F, 0.0F};
    std::array<int, kSampleCount> face = {-1, -1, -1, -1};  ///< index in faces_; -1: none
  };
  struct Corner {
    Eigen::Vector3f point_C;
    Eigen::Vector3f pixel;  ///< u, v, 1 / depth
  };

  [[nodiscard]] Corner corner(const Eigen::Vector3f& point_C) const;
  [[nodiscard]] bool mayBeSeen(const DrawItem& item, const Pose& X_CV) const;
  void drawClipped(const std::array<Eigen::Vector3f, 3>& points_C);
  void drawTriangle(const Corner& first, const Corner& second, const Corner& third);
  [[nodiscard]] Lanes reachOfUnitDepth(const Lanes& u, const Lanes& v,
                                       const NearLimit& limit) const;
  void see(const Lanes& covered, const Lanes& u, const Lanes& v, int number,
           PixelSamples& samples) const;
  [[nodiscard]] cv::Rect pixelsAround(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                                      const Eigen::Vector3f& c) const;
  [[nodiscard]] SeenFace makeFace(const Corner& first, const Corner& second,
                                  const Corner& third) const;

  const View& view_;
  const EdgePixels& edges_;
  const cv::Mat& seen_items_;
  cv::Rect place_;
  float fx_, fy_, cx_, cy_, near_, farthest_;
  std::vector<PixelSamples> samples_;
  std::vector<SeenFace> faces_;
  std::vector<Corner> corners_;  ///< of the item being drawn

  // The item being drawn.
  int number_ = 0;
  bool double_sided_ = false;
  bool stands_still_ = false;
  bool has_holes_ = false;
};

}  // namespace synthetic_dataset::render
