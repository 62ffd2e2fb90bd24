#include "render/geometry/silhouette_bits.h"

#include <algorithm>
#include <set>

#include "render/parts/item_groups.h"
#include "render/pixels/pixel_bands.h"

namespace synthetic_dataset::render {
namespace {

/// Whether all of an object's drawn items can move and are opaque.
bool isDrawnWhole(const std::vector<DrawItem>& items, const LinkSelection& drawn,
                  std::uint32_t identifier) {
  return std::none_of(items.begin(), items.end(), [&](const DrawItem& item) {
    return item.identifier == identifier && drawn[item.link] &&
           (item.stands_still || item.transparent);
  });
}

/// The first bit that no overlapping object has; 0 when all are taken.
template <class Objects>
std::uint8_t freeBit(const Objects& objects, const cv::Rect& pixels) {
  unsigned taken = 0;
  for (const auto& other : objects) {
    if (!(other.place.pixels & pixels).empty()) taken |= other.place.bit;
  }
  return static_cast<std::uint8_t>(~taken & (taken + 1U));
}

}  // namespace

SilhouetteBits::SilhouetteBits(const DrawList& draw_list, const View& view,
                               const std::vector<Pose>& X_WL, const LinkSelection& drawn)
    : draw_list_(&draw_list), drawn_(drawn) {
  std::set<std::uint32_t> identifiers;
  for (const DrawItem& item : draw_list.items()) {
    if (item.identifier != 0 && drawn[item.link]) identifiers.insert(item.identifier);
  }
  for (const std::uint32_t identifier : identifiers) {
    if (!isDrawnWhole(draw_list.items(), drawn, identifier)) continue;
    const cv::Rect pixels =
        boundsOf(regionsOf(draw_list.items(), view, X_WL, [&](const DrawItem& item) {
          return item.identifier == identifier && drawn[item.link];
        }));
    const std::uint8_t bit = pixels.empty() ? 0 : freeBit(objects_, pixels);
    if (bit != 0) objects_.push_back({identifier, {bit, pixels}});
  }
}

std::uint8_t SilhouetteBits::of(const DrawItem& item) const {
  const Object* object = item.identifier != 0 ? objectOf(item.identifier) : nullptr;
  return object != nullptr ? object->place.bit : 0;
}

std::optional<SilhouetteBits::Place> SilhouetteBits::find(const LinkSelection& links) const {
  if (objects_.empty()) return std::nullopt;
  const std::vector<DrawItem>& items = draw_list_->items();
  const auto first = std::find_if(items.begin(), items.end(),
                                  [&](const DrawItem& item) { return links[item.link]; });
  const Object* object = first != items.end() ? objectOf(first->identifier) : nullptr;
  if (object == nullptr) return std::nullopt;
  const bool are_the_object = std::all_of(items.begin(), items.end(), [&](const DrawItem& item) {
    return links[item.link] == (item.identifier == object->identifier && drawn_[item.link]);
  });
  return are_the_object ? std::optional(object->place) : std::nullopt;
}

const SilhouetteBits::Object* SilhouetteBits::objectOf(std::uint32_t identifier) const {
  const auto found = std::find_if(objects_.begin(), objects_.end(), [&](const Object& object) {
    return object.identifier == identifier;
  });
  return found != objects_.end() ? &*found : nullptr;
}

}  // namespace synthetic_dataset::render
