#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/labels/label_images.h"
#include "render/labels/label_painter.h"
#include "render/labels/silhouette_painter.h"
#include "render/parts/draw_list.h"
#include "render/pending_picture.h"
#include "render/picture_makers.h"
#include "render/render_options.h"
#include "render/view.h"
#include "world/look.h"
#include "world/world.h"

namespace synthetic_dataset::render {

/// Where a colour pass samples each pixel.
enum class Sampling {
  kSmooth,  ///< at edges in several places (RenderOptions::samples), averaged: for viewing
  kCentre,  ///< at its centre only, as labels do: outlines match those of the labels exactly
};

/// What a colour pass shows.
struct ColourPass {
  LinkSelection drawn;    ///< the links that are seen
  LinkSelection casting;  ///< the links that cast shadows
  Sampling sampling = Sampling::kSmooth;

  /// The pixels that are drawn; all others are undefined. Empty: the whole image.
  std::vector<cv::Rect> regions = {};

  float exposure = 1.0F;  ///< multiplies all light, before bright light is compressed
};

/// Draws the world's links offscreen. The same calls give the same pixels.
///
/// Every pixel is sampled at its centre, which in OpenCV's convention is at whole coordinates;
/// colour and labels share one vertex stage, so their edges are the same.
///
/// Through a lens with distortion, labels and colours are what each pixel's own ray sees. (If there
/// is a sky, a background picture or glass, colours are resampled from pinhole pictures of twice
/// the density.) Where the lens sees nothing, colour is black and the labels are 0. An equidistant
/// lens can see what is beside and behind it: depth, which is z of the optical frame, is then 0 or
/// negative.
class Renderer {
 public:
  /// @param description  the lights, ambient light and background; copied
  /// @param links  what can be drawn; the links pointed to have to outlive the renderer
  /// @throws Error when no OpenGL context is available, or the world has too many lights
  Renderer(const world::Description& description, const std::vector<world::LinkInstance>& links,
           const RenderOptions& options);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Sets how everything is lit and painted from now on. Initially, and with a Look made from the
  /// description only, it is as the description says.
  /// @param look  of the description that this renderer was made with
  void setLook(const world::Look& look);

  /// A counter that increases whenever the look changes: what was drawn before is out of date.
  [[nodiscard]] std::int64_t lookRevision() const;

  /// The picture: CV_8UC3, blue green red.
  /// @param X_WL  the pose of each link
  [[nodiscard]] cv::Mat colour(const View& view, const std::vector<Pose>& X_WL,
                               const ColourPass& pass);

  /// Like colour(), in two steps: draws now, and returns a function that makes the picture later,
  /// in any thread, without waiting for other pictures to be drawn.
  [[nodiscard]] PendingPicture draw(const View& view, const std::vector<Pose>& X_WL,
                                    const ColourPass& pass);

  /// Draws pictures that follow one another closely, as those of an exposure do: draw() at each
  /// moment, except that all share the placement of the shadow maps, and that whatever moves by
  /// less than two texels of a map keeps casting the same shadow.
  /// @param moments  their rows are ignored
  /// @param see  is called with each picture before the next is drawn
  void drawExposure(const CameraModel& camera, const std::vector<RollingMoment>& moments,
                    const ColourPass& pass, const std::function<void(PendingPicture)>& see);

  /// Draws a picture whose rows are taken one after the other: each shows what is seen at its own
  /// time. Lights and shadows are those of the row's band; if there is a sky, a background picture
  /// or glass, so is everything else.
  /// @param pass  of the whole image
  [[nodiscard]] PendingPicture draw(const RollingView& view, const ColourPass& pass);

  /// Labels of what each pixel's centre sees: an object's identifier is its index + 1, that of
  /// everything else 0. Which see-through surfaces (alpha below 1) hide what is behind them is
  /// determined by RenderOptions::glass_in_labels.
  [[nodiscard]] LabelImages labels(const View& view, const std::vector<Pose>& X_WL,
                                   const LabelPass& pass);

  /// Labels of a picture whose rows are taken one after the other: each pixel at its row's time, in
  /// the optical frame of that time.
  [[nodiscard]] LabelImages labels(const RollingView& view, const LabelPass& pass);

  /// The distance [m] along each pixel's ray to what its centre sees: CV_32FC1, infinity where
  /// there is nothing but the background, 0 where the lens sees nothing. Glass counts as for
  /// labels().
  [[nodiscard]] cv::Mat distances(const View& view, const std::vector<Pose>& X_WL,
                                  const LinkSelection& drawn);

  /// What the selected links would cover if nothing stood in front of them, including beyond the
  /// image's edge. Inside the image, its pixels are those that labels() gives when only these links
  /// are drawn.
  [[nodiscard]] Silhouette silhouette(const View& view, const std::vector<Pose>& X_WL,
                                      const LinkSelection& links);

  /// The silhouette in a picture whose rows are taken one after the other.
  [[nodiscard]] Silhouette silhouette(const RollingView& view, const LinkSelection& links);

  /// A rectangle of pixels outside which the selected links are not seen; it may be slightly too
  /// large.
  [[nodiscard]] cv::Rect reach(const View& view, const std::vector<Pose>& X_WL,
                               const LinkSelection& links) const;

  /// The reach in a picture whose rows are taken one after the other.
  [[nodiscard]] cv::Rect reach(const RollingView& view, const LinkSelection& links) const;

  /// Makes pictures that have been drawn, in the background.
  [[nodiscard]] PictureMakers& makers();

  /// The version of OpenGL: "4.5 (Core Profile) Mesa 22.3.6".
  [[nodiscard]] std::string glVersion() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::render
