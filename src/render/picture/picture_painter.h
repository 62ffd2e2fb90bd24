#pragma once

#include <array>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/edges/edge_smoother.h"
#include "render/geometry/geometry_images.h"
#include "render/geometry/geometry_painter.h"
#include "render/geometry/silhouette_bits.h"
#include "render/labels/silhouette_painter.h"
#include "render/parts/draw_list.h"
#include "render/picture/changed_pixels.h"
#include "render/picture/light_painter.h"
#include "render/shadows/shadow_painter.h"

namespace synthetic_dataset::render {

/// What OpenGL has drawn for a picture.
struct UnfinishedPicture {
  cv::Mat elsewhere;               ///< CV_8UC3, of the whole picture: all pixels that are not
                                   ///< in `pixels`; empty if there are none
  cv::Mat pixels;                  ///< CV_8UC1, of the whole picture: 255 for pixels to light
  std::vector<cv::Rect> regions;   ///< contain all of `pixels`
  UnlitPixels unlit;               ///< `pixels`, and their neighbours if edges are smoothed
  std::optional<EdgeScene> edges;  ///< nothing if edges are not smoothed
};

/// @return CV_8UC3, blue green red, sRGB-encoded
[[nodiscard]] cv::Mat finished(const UnfinishedPicture& picture, const EdgeSmoother& smoother);

/// The objects that together make pictures. The references have to outlive all picture painters.
struct PictureCrew {
  const GlFunctions& gl;
  const DrawList& draw_list;
  const std::vector<world::Light>& lights;
  GeometryPainter& geometry_painter;
  ShadowPainter& shadow_painter;
  LightPainter& light_painter;
  EdgeSmoother& edge_smoother;
  bool smooths;  ///< whether edges are smoothed when smooth pictures are requested
  bool keeps;    ///< whether anything is kept from picture to picture
};

/// Draws pictures of one size.
///
/// When a picture has the same view as the one before, what never moves is drawn once and kept,
/// with its light; light is computed again only where something else is seen, or casts its shadow.
/// Every pixel is the same as if nothing were kept.
class PicturePainter {
 public:
  PicturePainter(const PictureCrew& crew, const cv::Size& size);

  [[nodiscard]] cv::Size size() const { return image_.size(); }

  /// Forgets what was drawn so far, as the look has changed.
  void forget();

  /// Whether the last picture had this view.
  [[nodiscard]] bool drewFrom(const View& view) const;

  /// @param casting  the links that cast shadows
  /// @param smooth  whether edges are made from several samples per pixel, not only its centre
  /// @param regions  the pixels that are wanted; empty for the whole picture
  [[nodiscard]] UnfinishedPicture paint(const ColourScene& scene, const LinkSelection& casting,
                                        bool smooth, const std::vector<cv::Rect>& regions);

  /// What the pixels' centres see, which a picture and labels of the same links have in common. The
  /// images are shared, and must not be written to.
  [[nodiscard]] GeometryImages geometry(const View& view, const std::vector<Pose>& X_WL,
                                        const LinkSelection& drawn);

  /// The pixels that links cover, hidden or not, if they are known from the last drawing.
  [[nodiscard]] std::optional<CoveredPixels> covered(const View& view,
                                                     const std::vector<Pose>& X_WL,
                                                     const LinkSelection& links) const;

 private:
  /// What the geometry of the surfaces that never move depends on.
  struct GeometryKey {
    Eigen::Matrix4d clip_from_camera = Eigen::Matrix4d::Zero();
    Eigen::Matrix4d X_WC = Eigen::Matrix4d::Zero();
    LinkSelection drawn;  ///< those that never move

    [[nodiscard]] bool operator==(const GeometryKey& other) const;
  };

  /// What their light depends on in addition.
  struct LightKey {
    std::vector<Eigen::Matrix4d> shadows;
    LinkSelection casting;  ///< those that never move
    float exposure = 0.0F;
    std::vector<double> lens;  ///< of which this is a face, and its pose

    [[nodiscard]] bool operator==(const LightKey& other) const;
  };

  /// A picture of what never moves.
  struct KeptPicture {
    LightKey key;
    cv::Mat pixels;  ///< empty until the key occurs a second time; never written to
    cv::Mat edges;   ///< CV_8UC1: 255 where `pixels` are smoothed; empty if none are
  };

  /// What geometry_ shows.
  struct Content {
    LinkSelection drawn;
    std::vector<Eigen::Matrix4d> X_WL;
    cv::Rect pixels;  ///< all others are undefined

    /// Whether it includes the pixels of another content.
    [[nodiscard]] bool has(const Content& other) const;
  };

  [[nodiscard]] GeometryImages read(const cv::Rect& pixels);
  void readOverKept();
  void forgetContent();
  [[nodiscard]] LightKey lightKey(const ColourScene& scene, const LinkSelection& casting) const;
  void drawGeometry(const View& view, const std::vector<Pose>& X_WL, const LinkSelection& drawn,
                    const cv::Rect& pixels);
  void drawStandingGeometry(const View& view, const std::vector<Pose>& X_WL,
                            const LinkSelection& drawn);
  [[nodiscard]] const KeptPicture* keptPicture(const ColourScene& scene,
                                               const LinkSelection& casting, bool smooth);
  void paintShadows(const ColourScene& scene, const LinkSelection& casting, const cv::Rect& pixels);
  [[nodiscard]] cv::Mat changedPixels(const ColourScene& scene, const LinkSelection& casting,
                                      const cv::Mat& edges, const cv::Mat& wanted, bool wants_all);
  [[nodiscard]] int reach(const ColourScene& scene) const;
  [[nodiscard]] cv::Rect neededFor(const ColourScene& scene,
                                   const std::vector<cv::Rect>& regions) const;
  [[nodiscard]] cv::Mat wantedPixels(const std::vector<cv::Rect>& regions) const;
  [[nodiscard]] UnfinishedPicture light(const ColourScene& scene, const LinkSelection& seen,
                                        bool see_through, bool smooth, const cv::Mat& pixels);
  [[nodiscard]] SeenGeometry seenAround(const cv::Rect& place, const ColourScene& scene);
  [[nodiscard]] Occluders occludersAround(const cv::Rect& place, const ColourScene& scene);
  [[nodiscard]] cv::Mat plainPicture(float exposure) const;

  PictureCrew crew_;
  cv::Rect image_;
  Framebuffer geometry_;
  Framebuffer overlay_;
  GeometryKey geometry_key_;        ///< of geometry_
  SilhouetteBits bits_;             ///< in geometry_
  bool has_drawn_ = false;          ///< at least once
  std::optional<Content> content_;  ///< of geometry_; nothing if that is what never moves
  GeometryImages images_;           ///< of content_; empty until all of it has been read
  std::optional<Framebuffer> kept_geometry_;
  GeometryImages kept_images_;                ///< of kept_geometry_; empty until they are read
  bool keeps_geometry_ = false;               ///< whether kept_geometry_ is that of geometry_key_
  std::vector<cv::Rect> covered_;             ///< where geometry_ may differ from kept_geometry_
  std::array<KeptPicture, 2> kept_pictures_;  ///< not smoothed, and smoothed
};

}  // namespace synthetic_dataset::render
