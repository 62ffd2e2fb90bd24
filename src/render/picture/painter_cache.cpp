#include "render/picture/painter_cache.h"

#include <algorithm>
#include <cstddef>

namespace synthetic_dataset::render {
namespace {

/// What a painter of this size takes, of geometry, light and what is kept of them [byte].
std::size_t bytesOf(const cv::Size& size) {
  constexpr std::size_t kPixelBytes = 112;
  return kPixelBytes * static_cast<std::size_t>(size.area());
}

/// How many painters of this size there may be.
std::size_t mostOf(const cv::Size& size) { return RecentViews::mostOf(bytesOf(size)); }

}  // namespace

PicturePainter& PainterCache::get(const View& view) {
  auto found = std::find_if(entries_.begin(), entries_.end(),
                            [&](const Entry& entry) { return entry.painter->drewFrom(view); });
  if (found == entries_.end()) found = freeFor(view);
  std::rotate(entries_.begin(), found, found + 1);
  return *entries_.front().painter;
}

const PicturePainter* PainterCache::find(const View& view) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.painter->drewFrom(view);
  });
  return found != entries_.end() ? found->painter.get() : nullptr;
}

void PainterCache::forget() {
  for (const Entry& entry : entries_) entry.painter->forget();
  recent_.forget();  // a view that comes back looks different then
}

/// A painter for a place from which none of them drew last: one for all places that do not come
/// back, and one for each that does, as long as there is room; of large pictures, one for all.
std::vector<PainterCache::Entry>::iterator PainterCache::freeFor(const View& view) {
  const cv::Size size(view.camera.width(), view.camera.height());
  const bool comes_back = mostOf(size) > 1 && recent_.comesBack(view);
  std::size_t count = 0;
  auto last = entries_.end();
  for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
    if (entry->painter->size() != size || entry->comes_back != comes_back) continue;
    ++count;
    last = entry;
  }
  if (count >= (comes_back ? mostOf(size) : 1)) return last;
  if (!comes_back) makeRoomFor(size);
  entries_.push_back({std::make_unique<PicturePainter>(crew_, size), comes_back});
  return entries_.end() - 1;
}

/// Painters of sizes that were not asked for lately go: a lens whose focal length changes from
/// scene to scene has faces of other sizes in each.
void PainterCache::makeRoomFor(const cv::Size& size) {
  constexpr std::size_t kMemory = 512U << 20U;  // [byte] of all for places that do not come back
  std::size_t bytes = bytesOf(size);
  const auto isLeftOver = [&](const Entry& entry) {
    if (entry.comes_back) return false;
    bytes += bytesOf(entry.painter->size());
    return bytes > kMemory;
  };
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(), isLeftOver), entries_.end());
}

}  // namespace synthetic_dataset::render
