#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/geometry/geometry_images.h"
#include "render/parts/draw_list.h"
#include "render/picture/possible_changes.h"
#include "render/shadows/changed_texels.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// What the pixels of a picture see, including what moves.
struct SeenGeometry {
  GeometryImages images;
  cv::Rect place;  ///< of these pixels in the picture

  /// CV_32FC3, of the picture: the pixels' rays, along which depths are measured; empty for a
  /// pinhole camera.
  cv::Mat rays = {};

  /// CV_32FC1: up to how far away what is seen affects each pixel's light [px]; empty if nothing
  /// does.
  cv::Mat reaches = {};
};

/// Finds which pixels of a picture differ from those of a picture of what never moves.
///
/// Lighting is the most expensive part of a picture, so it pays to test each pixel within the
/// bounds: does it see something that moves, and if not, has the shadow map changed around its
/// place?
class ChangedPixels {
 public:
  /// The references have to outlive this.
  ChangedPixels(const DrawList& draw_list, const View& view) : draw_list_(draw_list), view_(view) {}

  /// @param regions  outside which nothing has changed
  /// @param seen  at least the pixels of these regions
  /// @param texels  of each shadow map
  /// @param edges  CV_8UC1, not 0 where pixels of the picture of what never moves are smoothed;
  ///   empty if no pixels are
  /// @return CV_8UC1, 255 for pixels that differ, else 0
  [[nodiscard]] cv::Mat find(const PossibleChanges& regions, const SeenGeometry& seen,
                             const std::vector<ChangedTexels>& texels, const cv::Mat& edges) const;

  /// Adds the pixels that differ because pixels beside them do.
  /// @param pixels  those that differ in what their centres see; not written to
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
