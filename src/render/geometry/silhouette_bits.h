#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/parts/draw_list.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// Which bit of a stencil buffer each object sets where it is drawn, whatever hides it: so one
/// drawing of all of them gives the silhouette of each.
///
/// Objects that are apart in the picture share a bit. One without a bit, because there is none left
/// or because of how it is drawn, is drawn by itself.
class SilhouetteBits {
 public:
  /// Where links alone set their bit.
  struct Place {
    std::uint8_t bit = 0;
    cv::Rect pixels;  ///< the links cover none beside them
  };

  /// No objects.
  SilhouetteBits() = default;

  /// @param view  without distortion
  /// @param drawn  the links that are drawn
  SilhouetteBits(const DrawList& draw_list, const View& view, const std::vector<Pose>& X_WL,
                 const LinkSelection& drawn);

  /// What the item sets; 0 for nothing.
  [[nodiscard]] std::uint8_t of(const DrawItem& item) const;

  /// Nothing unless the links are all those of an object that are drawn.
  [[nodiscard]] std::optional<Place> find(const LinkSelection& links) const;

 private:
  struct Object {
    std::uint32_t identifier = 0;
    Place place;
  };

  [[nodiscard]] const Object* objectOf(std::uint32_t identifier) const;

  const DrawList* draw_list_ = nullptr;
  LinkSelection drawn_;
  std::vector<Object> objects_;
};

}  // namespace synthetic_dataset::render
