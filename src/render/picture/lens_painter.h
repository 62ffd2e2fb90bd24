#pragma once

#include <array>
#include <memory>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/lens/lens_eye.h"
#include "render/lens/lens_surfaces.h"
#include "render/pending_picture.h"
#include "render/picture/picture_painter.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// Makes pictures through lenses with distortion that show opaque surfaces only, without sky,
/// background picture or glass.
///
/// What each pixel's own ray sees is found first (LensEye), then lit once, and edges are smoothed
/// with what the samples' own rays see. As in PicturePainter, what never moves is kept with its
/// light.
class LensPainter {
 public:
  LensPainter(const PictureCrew& crew, LensEye& eye) : crew_(crew), eye_(eye) {}

  /// @param casting  the links that cast shadows
  /// @param smooth  whether edges are made from several samples per pixel, not only its centre
  /// @param regions  the pixels that are wanted; empty for the whole picture
  [[nodiscard]] PendingPicture paint(const ColourScene& scene, const LinkSelection& casting,
                                     bool smooth, const std::vector<cv::Rect>& regions);

  /// Paints a picture whose rows are taken one after the other, from `rows`. Each band has its own
  /// lights and shadows.
  /// @param scene  at some time during the picture
  [[nodiscard]] PendingPicture paintInRows(const ColourScene& scene, const RollingView& rows,
                                           const LinkSelection& casting, bool smooth);

  /// Forgets what was painted so far, as the look has changed.
  void forget() { kept_.clear(); }

 private:
  /// What a picture of what never moves depends on.
  struct Key {
    std::shared_ptr<const LensMap> lens;
    Eigen::Matrix4d X_WC;
    LinkSelection drawn;    ///< those that never move
    LinkSelection casting;  ///< those that never move
    std::vector<Eigen::Matrix4d> shadows;
    float exposure = 0.0F;
    LightDetail detail = LightDetail::kSimple;
    bool smooth = false;

    [[nodiscard]] bool operator==(const Key& other) const;
  };
  struct Kept {
    Key key;
    cv::Mat pixels;             ///< empty until the key occurs a second time; never written to
    cv::Mat edges;              ///< CV_8UC1: 255 where `pixels` are smoothed; empty if none are
    StandingSurfaces surfaces;  ///< kept as long as there is room
  };

  [[nodiscard]] const Kept* kept(const ColourScene& scene, const LensSight& sight,
                                 const LinkSelection& casting, bool smooth);
  [[nodiscard]] cv::Mat possibleSurfaces(const ColourScene& scene,
                                         const std::vector<Pose>& X_WL_too) const;

  struct Band;
  [[nodiscard]] std::vector<Band> bandsOfRows(const ColourScene& scene, const RollingView& rows,
                                              const LinkSelection& casting) const;

  PictureCrew crew_;
  LensEye& eye_;
  std::vector<Kept> kept_;  ///< the most recently used first
};

}  // namespace synthetic_dataset::render
