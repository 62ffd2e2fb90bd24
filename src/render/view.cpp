#include "render/view.h"

#include <algorithm>
#include <cstddef>

#include "base/placement.h"

namespace synthetic_dataset::render {
namespace {

/// The moments before and after a row, and how far the row is from the one to the other, 0 .. 1.
struct Between {
  const RollingMoment& from;
  const RollingMoment& to;
  double share;
};

Between around(double row, const std::vector<RollingMoment>& moments) {
  const auto after = std::find_if(moments.begin() + 1, moments.end() - 1,
                                  [&](const RollingMoment& moment) { return moment.row >= row; });
  const RollingMoment& from = *(after - 1);
  return {from, *after, std::clamp((row - from.row) / (after->row - from.row), 0.0, 1.0)};
}

Pose between(const Pose& before, const Pose& after, double share) {
  if (before.matrix() == after.matrix()) return before;
  return base::between(base::Placement(before), base::Placement(after), share).pose();
}

}  // namespace

Eigen::Matrix4d clipFromCamera(const CameraModel& camera) {
  const Intrinsics& k = camera.intrinsics();
  const double near = camera.near();
  const double far = camera.far();
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  clip(0, 0) = 2.0 * k.fx / camera.width();
  clip(0, 2) = 2.0 * (k.cx + 0.5) / camera.width() - 1.0;
  clip(1, 1) = 2.0 * k.fy / camera.height();
  clip(1, 2) = 2.0 * (k.cy + 0.5) / camera.height() - 1.0;
  clip(2, 2) = -near / (far - near);
  clip(2, 3) = near * far / (far - near);
  clip(3, 2) = 1.0;
  return clip;
}

RollingMoment RollingView::at(double row) const {
  return at(row, LinkSelection(moments.front().X_WL.size(), true));
}

RollingMoment RollingView::at(double row, const LinkSelection& links) const {
  const auto [from, to, share] = around(row, moments);
  RollingMoment here{row, between(from.X_WC, to.X_WC, share), from.X_WL};
  for (std::size_t link = 0; link < links.size(); ++link) {
    if (links[link]) here.X_WL[link] = between(from.X_WL[link], to.X_WL[link], share);
  }
  return here;
}

Pose RollingView::X_CL(std::size_t link, double row) const {
  const auto [from, to, share] = around(row, moments);
  return between(from.X_WC, to.X_WC, share).inverse() *
         between(from.X_WL[link], to.X_WL[link], share);
}

cv::Rect RollingView::rowsOf(int band) const {
  const int height = camera.height();
  const int first = band * height / bands;
  const int end = (band + 1) * height / bands;
  return {0, first, camera.width(), end - first};
}

}  // namespace synthetic_dataset::render
