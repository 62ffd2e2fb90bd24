#pragma once

#include <cstddef>
#include <vector>

#include "render/parts/draw_list.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// The poses of links in the camera's frame when each row of a picture is taken.
class RowPoses {
 public:
  /// @param draw_list  has to outlive this object
  /// @param drawn  the links whose poses are needed
  RowPoses(const RollingView& view, const DrawList& draw_list, const LinkSelection& drawn);

  [[nodiscard]] bool cameraStands() const { return camera_stands_; }

  /// The number of the picture's rows.
  [[nodiscard]] int rowCount() const { return row_count_; }

  [[nodiscard]] const Pose& X_CL(std::size_t link, int row) const {
    const std::vector<Pose>& poses = X_CL_[link];
    return poses.size() == 1 ? poses.front() : poses[static_cast<std::size_t>(row)];
  }

  /// The pose of an item, given by its number.
  [[nodiscard]] Pose X_CV(int item, int row) const;

 private:
  const DrawList& draw_list_;
  int row_count_;
  bool camera_stands_;
  std::vector<std::vector<Pose>> X_CL_;  ///< for each link: one per row, or one for all rows
};

}  // namespace synthetic_dataset::render
