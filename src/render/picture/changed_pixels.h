#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/geometry/geometry_images.h"
#include "render/parts/draw_list.h"
#include "render/picture/possible_changes.h"
#include "render/shadows/changed_texels.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// What the pixels of a picture see, with what moves.
struct SeenGeometry {
  GeometryImages images;
  cv::Rect place;  ///< of these pixels in the picture

  /// CV_32FC3 of the picture: what pixels look along, in whose lengths depths are; empty for those
  /// of a pinhole.
  cv::Mat rays = {};

  /// CV_32FC1: how far away what is seen has a part in each pixel's light [px]; empty where nothing
  /// has.
  cv::Mat reaches = {};
};

/// Finds which pixels of a picture differ from those of a picture of what never moves.
///
/// Light is what pictures cost most, so that it pays to look at each pixel within the bounds: does
/// it see something that moves, and if not, has the shadow map changed around its place?
class ChangedPixels {
 public:
  /// The references have to outlive it.
  ChangedPixels(const DrawList& draw_list, const View& view) : draw_list_(draw_list), view_(view) {}

  /// @param regions  outside of which there is nothing to be found
  /// @param seen  the pixels of these regions at least
  /// @param texels  of each shadow map
  /// @param edges  CV_8UC1, not 0 where pixels show what is around their centre in a picture of
  ///     what never moves; empty where all pixels show what is at their centre
  /// @return CV_8UC1, 255 for such pixels, else 0
  [[nodiscard]] cv::Mat find(const PossibleChanges& regions, const SeenGeometry& seen,
                             const std::vector<ChangedTexels>& texels, const cv::Mat& edges) const;

  /// The pixels that differ because pixels beside them do.
  /// @param pixels  that differ by what their centres see; not written to
  [[nodiscard]] static cv::Mat withEdges(const cv::Mat& pixels, const PossibleChanges& regions,
                                         const cv::Mat& edges);

 private:
  void markMoving(const SeenGeometry& seen, cv::Mat& pixels) const;
  static void markNear(const SeenGeometry& seen, cv::Mat& pixels);
  void markShaded(const cv::Mat& candidates, const SeenGeometry& seen, const ChangedTexels& texels,
                  cv::Mat& pixels) const;

  const DrawList& draw_list_;
  const View& view_;
};

}  // namespace synthetic_dataset::render
