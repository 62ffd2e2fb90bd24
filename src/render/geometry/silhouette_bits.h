#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/parts/draw_list.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// Assigns each object a bit of the stencil buffer, which it sets wherever it is drawn, even where
/// it is hidden: drawing all objects once thus gives the silhouette of each.
///
/// Objects that do not overlap in the picture may share a bit. The silhouette of an object without
/// a bit, because none is left or because of how it is drawn, has to be drawn separately.
class SilhouetteBits {
 public:
  /// A bit, and the pixels in which no links but an object's set it.
  struct Place {
    std::uint8_t bit = 0;
    cv::Rect pixels;  ///< the object's links cover no others
  };

  /// No objects.
  SilhouetteBits() = default;

  /// @param view  without distortion
  /// @param drawn  the links that are drawn
  SilhouetteBits(const DrawList& draw_list, const View& view, const std::vector<Pose>& X_WL,
                 const LinkSelection& drawn);

  /// The bit that the item sets; 0 for none.
  [[nodiscard]] std::uint8_t of(const DrawItem& item) const;

  /// The place of an object, if the links are exactly the drawn links of that object.
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
