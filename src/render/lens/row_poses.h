#pragma once

#include <cstddef>
#include <vector>

#include "render/link_selection.h"
#include "render/parts/draw_list.h"
#include "render/rolling_view.h"

namespace synthetic_dataset::render {

/// Where the camera has links when each row of a picture is taken.
class RowPoses {
 public:
  /// @param parts  has to outlive this
  /// @param drawn  the links that are asked for
  RowPoses(const RollingView& view, const DrawList& parts, const LinkSelection& drawn);

  [[nodiscard]] bool cameraStands() const { return camera_stands_; }

  /// Of the picture.
  [[nodiscard]] int rowCount() const { return row_count_; }

  [[nodiscard]] const Pose& X_CL(std::size_t link, int row) const {
    const std::vector<Pose>& poses = X_CL_[link];
    return poses.size() == 1 ? poses.front() : poses[static_cast<std::size_t>(row)];
  }

  /// Of a part by its number.
  [[nodiscard]] Pose X_CV(int part, int row) const;

 private:
  const DrawList& parts_;
  int row_count_;
  bool camera_stands_;
  std::vector<std::vector<Pose>> X_CL_;  ///< of each link: of each row, or one for all
};

}  // namespace synthetic_dataset::render
