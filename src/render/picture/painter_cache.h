#pragma once

#include <memory>
#include <vector>

#include "render/picture/picture_painter.h"
#include "render/recent_views.h"

namespace synthetic_dataset::render {

/// Keeps a picture painter for each recurring view, so that several cameras that stand still each
/// keep what was drawn for them.
class PainterCache {
 public:
  explicit PainterCache(const PictureCrew& crew) : crew_(crew) {}

  /// The painter whose last picture had this view, else one of the picture's size. Valid until the
  /// next call.
  [[nodiscard]] PicturePainter& get(const View& view);

  /// The painter whose last picture had this view, or null.
  [[nodiscard]] const PicturePainter* find(const View& view) const;

  /// Forgets everything that was drawn so far.
  void forget();

 private:
  struct Entry {
    std::unique_ptr<PicturePainter> painter;
    bool comes_back;  ///< whether the view that it was made for recurs
  };

  [[nodiscard]] std::vector<Entry>::iterator freeFor(const View& view);
  void makeRoomFor(const cv::Size& size);

  PictureCrew crew_;
  std::vector<Entry> entries_;  ///< the most recently used first
  RecentViews recent_;          ///< views that were not found in entries_
};

}  // namespace synthetic_dataset::render
