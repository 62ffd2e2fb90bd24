#include "render/picture/painter_cache.h"

#include <algorithm>
#include <cstddef>

namespace synthetic_dataset::render {
namespace {

/// The memory that a painter of this size takes, for geometry, light and what is kept of them
/// [byte].
std::size_t bytesOf(const cv::Size& size) {
  constexpr std::size_t kPixelBytes = 112;
  return kPixelBytes * static_cast<std::size_t>(size.area());
}

/// The maximum number of painters of this size.
std::size_t maxKept(const cv::Size& size) { return RecentViews::maxKept(bytesOf(size)); }

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
  recent_.forget();  // what was drawn from recurring views is out of date, too
}

/// Returns a painter for a view that no painter drew last: one for all views that do not recur, and
/// one for each that does, as long as there is room; for large pictures, one for all.
std::vector<PainterCache::Entry>::iterator PainterCache::freeFor(const View& view) {
  const cv::Size size(view.camera.width(), view.camera.height());
  const bool comes_back = maxKept(size) > 1 && recent_.comesBack(view);
  std::size_t count = 0;
  auto last = entries_.end();
  for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
    if (entry->painter->size() != size || entry->comes_back != comes_back) continue;
    ++count;
    last = entry;
  }
  if (count >= (comes_back ? maxKept(size) : 1)) return last;
  if (!comes_back) makeRoomFor(size);
  entries_.push_back({std::make_unique<PicturePainter>(crew_, size), comes_back});
  return entries_.end() - 1;
}

/// Removes painters of sizes that were not used recently: a lens whose focal length changes from
/// scene to scene has faces of different sizes in each.
void PainterCache::makeRoomFor(const cv::Size& size) {
  constexpr std::size_t kMemory = 512U << 20U;  // [byte] of all for views that do not recur
  std::size_t bytes = bytesOf(size);
  const auto isLeftOver = [&](const Entry& entry) {
    if (entry.comes_back) return false;
    bytes += bytesOf(entry.painter->size());
    return bytes > kMemory;
  };
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(), isLeftOver), entries_.end());
}

}  // namespace synthetic_dataset::render
