#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/gl/framebuffer.h"
#include "render/lens/lens_eye.h"
#include "render/parts/draw_list.h"
#include "render/parts/shader_family.h"
#include "render/view.h"
#include "synthetic_dataset/box.h"
#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::render {

/// What links would cover if nothing stood in front of them. Pixels are sampled at their centres.
struct Silhouette {
  Mask mask;                         ///< of the image
  std::optional<Box> box;            ///< of all pixels' areas [px], also beyond the image's edge
  std::int64_t pixels = 0;           ///< number of all pixels, also beyond the image's edge
  std::int64_t pixels_in_image = 0;  ///< number of pixels of the mask
};

/// What links cover, regardless of what hides them, in a part of an image.
struct CoveredPixels {
  cv::Rect place;  ///< the links cover no pixels outside it
  cv::Mat mask;    ///< CV_8UC1 of that size: 255 on the links, 0 elsewhere
};

/// Draws what links cover, in the image and beyond its edge.
///
/// Only the pixels within the links' projected bounds are drawn. In the image they are those of
/// LabelPainter. Beyond its edge the camera's grid of pixels continues: unchanged up to one image's
/// width and height away; farther away, which only things beside the camera reach, the rest is
/// drawn in up to kCoarseCells x kCoarseCells cells of whole pixels, counted by their area. Through
/// a lens with distortion the grid continues up to one image's width and height away, or as far as
/// the lens sees; for large images in cells of several pixels.
///
/// In a picture whose rows are taken one after the other, each row of the image has its own time.
/// Outside the image, rows have the time of the view's nearest moment.
class SilhouettePainter {
 public:
  static constexpr int kCoarseCells = 1024;

  /// @param draw_list, eye  have to outlive this painter
  SilhouettePainter(const GlFunctions& gl, const DrawList& draw_list, LensEye& eye);

  /// @param links  the links whose silhouette is drawn
  /// @param in_image  what they cover in the image, if that is known already
  [[nodiscard]] Silhouette paint(const View& view, const std::vector<Pose>& X_WL,
                                 const LinkSelection& links,
                                 const std::optional<CoveredPixels>& in_image);

  /// The silhouette in a picture whose rows are taken one after the other.
  [[nodiscard]] Silhouette paint(const RollingView& rows, const LinkSelection& links);

 private:
  struct Instant;
  struct Subject;  ///< what is painted, and where it stands
  struct Window;
  class Tally;

  [[nodiscard]] Silhouette paint(const Subject& subject, const CameraModel& camera,
                                 const std::optional<CoveredPixels>& in_image);
  [[nodiscard]] std::optional<Box> boundsOf(const Subject& subject,
                                            const CameraModel& camera) const;
  [[nodiscard]] cv::Mat drawPinhole(const Subject& subject, const View& view,
                                    const std::vector<Pose>& X_WL, const cv::Rect& region);
  [[nodiscard]] cv::Mat drawAt(const Instant& instant, const Subject& subject,
                               const CameraModel& camera, const cv::Rect& region);
  [[nodiscard]] cv::Mat draw(const Subject& subject, const Window& window, const cv::Rect& region);
  void addBesideTheImage(const Subject& subject, const CameraModel& camera, const Box& bounds,
                         Tally& tally);
  void addFarAway(const Subject& subject, const CameraModel& camera, const Box& bounds,
                  Tally& tally);
  void addBesideTheLens(const Subject& subject, const CameraModel& camera, const Box& bounds,
                        Tally& tally);

  const GlFunctions& gl_;
  const DrawList& draw_list_;
  LensEye& eye_;
  ShaderFamily programs_;
  std::optional<Framebuffer> target_;  // as large as the largest picture so far
};

}  // namespace synthetic_dataset::render
