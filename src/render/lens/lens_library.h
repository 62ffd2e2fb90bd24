#pragma once

#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "render/lens/lens_map.h"

namespace synthetic_dataset::render {

/// Makes each camera's LensMap once, as long as its focal lengths stay what they are.
class LensLibrary {
 public:
  /// Limit of kept maps of one lens that differ in their focal lengths alone: those that were
  /// asked for last.
  static constexpr std::size_t kMostZooms = 4;

  /// Good as long as somebody holds it.
  [[nodiscard]] std::shared_ptr<const LensMap> get(const CameraModel& camera);

 private:
  struct Zoom {
    double fx = 0.0;
    double fy = 0.0;
    std::shared_ptr<const LensMap> map;
  };

  /// By all that tells one lens's pictures from another's but their focal lengths.
  std::map<std::vector<double>, std::deque<Zoom>> lenses_;
};

/// The views of a lens's faces.
[[nodiscard]] std::vector<View> faceViews(const LensMap& lens, const View& view);

}  // namespace synthetic_dataset::render
