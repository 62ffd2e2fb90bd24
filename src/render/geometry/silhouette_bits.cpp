#include "render/geometry/silhouette_bits.h"

#include <algorithm>
#include <set>

#include "render/parts/part_groups.h"
#include "render/pixels/pixel_bands.h"

namespace synthetic_dataset::render {
namespace {

/// Whether all of an object is drawn with what moves, and hides what is behind it.
bool isDrawnWhole(const std::vector<Part>& parts, const LinkSelection& drawn,
                  std::uint32_t identifier) {
  return std::none_of(parts.begin(), parts.end(), [&](const Part& part) {
    return part.identifier == identifier && drawn[part.link] &&
           (part.stands_still || part.transparent);
  });
}

/// The first bit that nothing near has; 0 when all are taken.
template <class Objects>
std::uint8_t freeBit(const Objects& objects, const cv::Rect& pixels) {
  unsigned taken = 0;
  for (const auto& other : objects) {
    if (!(other.place.pixels & pixels).empty()) taken |= other.place.bit;
  }
  return static_cast<std::uint8_t>(~taken & (taken + 1U));
}

}  // namespace

SilhouetteBits::SilhouetteBits(const DrawList& parts, const View& view,
                               const std::vector<Pose>& X_WL, const LinkSelection& drawn)
    : parts_(&parts), drawn_(drawn) {
  std::set<std::uint32_t> identifiers;
  for (const Part& part : parts.parts()) {
    if (part.identifier != 0 && drawn[part.link]) identifiers.insert(part.identifier);
  }
  for (const std::uint32_t identifier : identifiers) {
    if (!isDrawnWhole(parts.parts(), drawn, identifier)) continue;
    const cv::Rect pixels = boundsOf(regionsOf(parts.parts(), view, X_WL, [&](const Part& part) {
      return part.identifier == identifier && drawn[part.link];
    }));
    const std::uint8_t bit = pixels.empty() ? 0 : freeBit(objects_, pixels);
    if (bit != 0) objects_.push_back({identifier, {bit, pixels}});
  }
}

std::uint8_t SilhouetteBits::of(const Part& part) const {
  const Object* object = part.identifier != 0 ? objectOf(part.identifier) : nullptr;
  return object != nullptr ? object->place.bit : 0;
}

std::optional<SilhouetteBits::Place> SilhouetteBits::find(const LinkSelection& links) const {
  if (objects_.empty()) return std::nullopt;
  const std::vector<Part>& parts = parts_->parts();
  const auto first =
      std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return links[part.link]; });
  const Object* object = first != parts.end() ? objectOf(first->identifier) : nullptr;
  if (object == nullptr) return std::nullopt;
  const bool are_the_object = std::all_of(parts.begin(), parts.end(), [&](const Part& part) {
    return links[part.link] == (part.identifier == object->identifier && drawn_[part.link]);
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
