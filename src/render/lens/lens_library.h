#pragma once

#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "render/lens/lens_map.h"

namespace synthetic_dataset::render {

/// Makes each camera's LensMap once, as long as its focal lengths do not change.
class LensLibrary {
 public:
  /// The maximum number of maps that are kept per lens and differ only in their focal lengths: the
  /// most recently used ones.
  static constexpr std::size_t kMostZooms = 4;

  /// The map is valid as long as the pointer is held.
  [[nodiscard]] std::shared_ptr<const LensMap> get(const CameraModel& camera);

 private:
  struct Zoom {
    double fx = 0.0;
    double fy = 0.0;
    std::shared_ptr<const LensMap> map;
  };

  /// By everything that distinguishes one lens's pictures from another's except focal lengths.
  std::map<std::vector<double>, std::deque<Zoom>> lenses_;
};

/// The views of a lens's faces.
[[nodiscard]] std::vector<View> faceViews(const LensMap& lens, const View& view);

}  // namespace synthetic_dataset::render
