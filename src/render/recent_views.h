#pragma once

#include <cstddef>
#include <deque>

#include <Eigen/Core>

#include "render/view.h"

namespace synthetic_dataset::render {

/// The views that pictures were taken from lately: what is drawn from one is worth keeping if it
/// comes back.
class RecentViews {
 public:
  /// Whether pictures are taken from here again and again, not only several of one instant;
  /// remembers this one.
  [[nodiscard]] bool comesBack(const View& view);

  void forget() { recent_.clear(); }

  /// From how many views something is kept that takes this much memory each [byte]; at least one.
  [[nodiscard]] static std::size_t mostOf(std::size_t bytes);

 private:
  struct Seen {
    Eigen::Matrix4d clip_from_camera;
    Eigen::Matrix4d X_WC;
  };

  std::deque<Seen> recent_;
};

}  // namespace synthetic_dataset::render
