#pragma once

#include <memory>
#include <vector>

#include "render/picture/picture_painter.h"
#include "render/recent_views.h"

namespace synthetic_dataset::render {

/// A painter of pictures for each of the places to which cameras come back, so that several cameras
/// that stand still each keep what they have drawn.
class PainterCache {
 public:
  explicit PainterCache(const PictureCrew& crew) : crew_(crew) {}

  /// The one that drew from this place last, else one of the picture's size. Good until the next
  /// call.
  [[nodiscard]] PicturePainter& get(const View& view);

  /// The one that drew from this place last, or null.
  [[nodiscard]] const PicturePainter* find(const View& view) const;

  /// Nothing that was drawn so far is of use any more.
  void forget();

 private:
  struct Entry {
    std::unique_ptr<PicturePainter> painter;
    bool comes_back;  ///< the place that it was made for does
  };

  [[nodiscard]] std::vector<Entry>::iterator freeFor(const View& view);
  void makeRoomFor(const cv::Size& size);

  PictureCrew crew_;
  std::vector<Entry> entries_;  ///< the last used first
  RecentViews recent_;          ///< that were not found in entries_
};

}  // namespace synthetic_dataset::render
