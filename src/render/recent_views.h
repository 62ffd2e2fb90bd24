#pragma once

#include <cstddef>
#include <deque>

#include <Eigen/Core>

#include "render/view.h"

namespace synthetic_dataset::render {

/// The views from which pictures were taken recently: what is drawn from a view is worth keeping if
/// that view recurs.
class RecentViews {
 public:
  /// Whether pictures are taken from this view repeatedly, rather than a few times for one instant.
  /// Records the view.
  [[nodiscard]] bool comesBack(const View& view);

  void forget() { recent_.clear(); }

  /// The number of views for which to keep data that takes this much memory each [byte]; at least
  /// one.
  [[nodiscard]] static std::size_t maxKept(std::size_t bytes);

 private:
  struct Seen {
    Eigen::Matrix4d clip_from_camera;
    Eigen::Matrix4d X_WC;
  };

  std::deque<Seen> recent_;
};

}  // namespace synthetic_dataset::render
