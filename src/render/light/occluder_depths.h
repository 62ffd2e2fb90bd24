#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <opencv2/core.hpp>

#include "render/light/ambient_occlusion.h"
#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// The columns and rows of four pixels of the picture.
struct FourPixels {
  std::array<int, kLaneCount> u;
  std::array<int, kLaneCount> v;
};

/// The pixels at some offsets from four adjacent ones in a row.
[[nodiscard]] inline FourPixels beside(int u, int v, const Lanes& du, const Lanes& dv) {
  FourPixels four;
  cv::v_store(four.u.data(), cv::v_round(du) + cv::v_int32x4(u, u + 1, u + 2, u + 3));
  cv::v_store(four.v.data(), cv::v_round(dv) + cv::v_setall_s32(v));
  return four;
}

/// The depths of possible occluders, four pixels at a time, with a margin around them.
class OccluderDepths {
 public:
  static constexpr int kMargin = 4;  ///< pixels around the known ones that may be read

  explicit OccluderDepths(const Occluders& seen)
      : place_(seen.place),
        k_(seen.intrinsics),
        rays_(seen.rays),
        x_(static_cast<float>(1.0 / k_.fx)),
        y_(static_cast<float>(1.0 / k_.fy)) {
    cv::copyMakeBorder(seen.depth, depths_, kMargin, kMargin, kMargin, kMargin + kLaneCount,
                       cv::BORDER_CONSTANT, cv::Scalar(0.0));
    if (rays_.empty()) return;
    cv::copyMakeBorder(rays_(place_), rays_, kMargin, kMargin, kMargin, kMargin + kLaneCount,
                       cv::BORDER_REPLICATE);
  }

  /// The depths of four adjacent pixels in a row, up to kMargin outside the known ones.
  [[nodiscard]] Lanes four(int u, int v) const {
    return cv::v_load(depths_.ptr<float>(v - place_.y + kMargin, u - place_.x + kMargin));
  }

  [[nodiscard]] Lanes3 raysOfFour(int u, int v) const {
    if (rays_.empty()) {
      const Lanes columns = lanes(static_cast<float>(u)) + Lanes(0.0F, 1.0F, 2.0F, 3.0F);
      return pinholeRays(columns, lanes(static_cast<float>(v)));
    }
    Lanes3 ray;
    cv::v_load_deinterleave(rays_.ptr<float>(v - place_.y + kMargin, u - place_.x + kMargin), ray.x,
                            ray.y, ray.z);
    return ray;
  }

  /// The depths of any four pixels; 0 outside the known ones.
  [[nodiscard]] Lanes at(const FourPixels& four) const {
    return {at(four.u[0], four.v[0]), at(four.u[1], four.v[1]), at(four.u[2], four.v[2]),
            at(four.u[3], four.v[3])};
  }

  /// The differences from the rays of four adjacent pixels in a row to the rays at some offsets. If
  /// those are outside the known pixels, the pixels at the opposite offsets are used instead.
  [[nodiscard]] Lanes3 wayTo(int u, int v, const Lanes& du, const Lanes& dv,
                             const Lanes3& rays) const {
    FourPixels there = beside(u, v, du, dv);
    std::array<float, kLaneCount> side{};
    for (std::size_t i = 0; i < side.size(); ++i) {
      const bool is_known = rays_.empty() || place_.contains({there.u[i], there.v[i]});
      side[i] = is_known ? 1.0F : -1.0F;
      if (is_known) continue;
      there.u[i] = 2 * (u + static_cast<int>(i)) - there.u[i];
      there.v[i] = 2 * v - there.v[i];
    }
    return (raysAt(there) - rays) * cv::v_load(side.data());
  }

  /// The rays of any four pixels; outside the known ones, that of the nearest known one.
  [[nodiscard]] Lanes3 raysAt(const FourPixels& four) const {
    const auto& [u, v] = four;
    if (rays_.empty()) {
      return pinholeRays(cv::v_cvt_f32(cv::v_load(u.data())), cv::v_cvt_f32(cv::v_load(v.data())));
    }
    std::array<cv::Vec3f, kLaneCount> rays;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const int column = std::clamp(u[i] - place_.x, 0, place_.width - 1);
      const int row = std::clamp(v[i] - place_.y, 0, place_.height - 1);
      rays[i] = rays_.at<cv::Vec3f>(row + kMargin, column + kMargin);
    }
    return {Lanes(rays[0][0], rays[1][0], rays[2][0], rays[3][0]),
            Lanes(rays[0][1], rays[1][1], rays[2][1], rays[3][1]),
            Lanes(rays[0][2], rays[1][2], rays[2][2], rays[3][2])};
  }

  [[nodiscard]] const cv::Rect& place() const { return place_; }

 private:
  [[nodiscard]] float at(int u, int v) const {
    const int column = u - place_.x;
    const int row = v - place_.y;
    if (column < 0 || row < 0 || column >= place_.width || row >= place_.height) return 0.0F;
    return depths_.at<float>(row + kMargin, column + kMargin);
  }

  [[nodiscard]] Lanes3 pinholeRays(const Lanes& u, const Lanes& v) const {
    return {(u - lanes(static_cast<float>(k_.cx))) * lanes(x_),
            (v - lanes(static_cast<float>(k_.cy))) * lanes(y_), lanes(1.0F)};
  }

  cv::Rect place_;
  Intrinsics k_;
  cv::Mat rays_;
  float x_;
  float y_;
  cv::Mat depths_;
};

}  // namespace synthetic_dataset::render
