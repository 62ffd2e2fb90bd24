#include "render/lens/row_poses.h"

#include <algorithm>
#include <utility>

namespace synthetic_dataset::render {
namespace {

bool isSame(const Pose& one, const Pose& other) { return one.matrix() == other.matrix(); }

}  // namespace

RowPoses::RowPoses(const RollingView& view, const DrawList& draw_list, const LinkSelection& drawn)
    : draw_list_(draw_list), row_count_(view.camera.height()) {
  const std::vector<RollingMoment>& moments = view.moments;
  const RollingMoment& first = moments.front();
  const auto stands = [&](const auto& pose_in) {
    return std::all_of(moments.begin(), moments.end(), [&](const RollingMoment& moment) {
      return isSame(pose_in(moment), pose_in(first));
    });
  };
  camera_stands_ = stands([](const RollingMoment& moment) { return moment.X_WC; });
  X_CL_.resize(first.X_WL.size());
  LinkSelection changing(X_CL_.size());
  for (std::size_t link = 0; link < X_CL_.size(); ++link) {
    if (!drawn[link]) continue;
    changing[link] =
        !camera_stands_ || !stands([&](const RollingMoment& moment) { return moment.X_WL[link]; });
    if (changing[link]) X_CL_[link].reserve(static_cast<std::size_t>(row_count_));
    if (!changing[link]) X_CL_[link] = {first.X_WC.inverse() * first.X_WL[link]};
  }
  for (int row = 0; row < row_count_; ++row) {
    const RollingMoment moment = view.at(row, changing);
    const Pose X_CW = moment.X_WC.inverse();
    for (std::size_t link = 0; link < X_CL_.size(); ++link) {
      if (changing[link]) X_CL_[link].push_back(X_CW * moment.X_WL[link]);
    }
  }
}

Pose RowPoses::X_CV(int item, int row) const {
  const DrawItem& here = draw_list_.items()[static_cast<std::size_t>(item) - 1];
  return X_CL(here.link, row) * here.X_LV;
}

}  // namespace synthetic_dataset::render
