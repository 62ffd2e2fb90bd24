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

/// Where a colour pass looks at each pixel.
enum class Sampling {
  kSmooth,  ///< by edges in several places (RenderOptions::samples), averaged: to look at
  kCentre,  ///< at its centre alone, as labels do: outlines fall exactly on those of the labels
};

/// What a colour pass shows.
struct ColourPass {
  LinkSelection drawn;    ///< the links that are seen
  LinkSelection casting;  ///< the links that cast shadows
  Sampling sampling = Sampling::kSmooth;

  /// The pixels that are drawn; what all others show is not sure. Empty: the whole image.
  std::vector<cv::Rect> regions = {};

  float exposure = 1.0F;  ///< multiplies all light, before bright light is compressed
};

/// Draws the world's links offscreen. The same calls give the same pixels.
///
/// Every pixel is sampled where OpenCV's convention has its centre, at whole coordinates; colour
/// and labels share one vertex stage, so their edges are the same.
///
/// Through a lens with distortion, labels and colours are what each pixel's own ray sees. (Where
/// there is a sky, a background picture or glass, colours are resampled from pinhole pictures of
/// twice the density.) Where the lens sees nothing, colour is black and the labels are 0. An
/// equidistant lens can see what is beside and behind it: depth, which is z of the optical frame,
/// is then 0 or negative.
class Renderer {
 public:
  /// @param description  the lights, ambient light and background; copied
  /// @param links  what can be drawn; the links pointed to have to outlive the renderer
  /// @throws Error when there is no OpenGL context to be had, or the world has too many lights
  Renderer(const world::Description& description, const std::vector<world::LinkInstance>& links,
           const RenderOptions& options);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// How everything is lit and painted from now on. At first, and with a Look of the description
  /// alone, it is as the description has it.
  /// @param look  of the description that this was made with
  void setLook(const world::Look& look);

  /// Counts up whenever something looks different: what was drawn before is out of date.
  [[nodiscard]] std::int64_t lookRevision() const;

  /// The picture: CV_8UC3, blue green red.
  /// @param X_WL  the pose of each link
  [[nodiscard]] cv::Mat colour(const View& view, const std::vector<Pose>& X_WL,
                               const ColourPass& pass);

  /// The same in two steps, of which the second need not wait for the first of other pictures:
  /// draws now; what is called later, in any thread, makes the picture of it.
  [[nodiscard]] PendingPicture draw(const View& view, const std::vector<Pose>& X_WL,
                                    const ColourPass& pass);

  /// Pictures that follow one another closely, as an exposure has them: draw() at each moment, but
  /// that shadow maps lie where they do for all of them, and that what moves by less than two
  /// texels of a map casts the same shadow.
  /// @param moments  without rows
  /// @param see  is called with each picture before the next is drawn
  void drawExposure(const CameraModel& camera, const std::vector<RollingMoment>& moments,
                    const ColourPass& pass, const std::function<void(PendingPicture)>& see);

  /// The same of a picture whose rows are taken one after the other: each shows what is seen at its
  /// own time. Lights and shadows are those of its band; where there is a sky, a background picture
  /// or glass, all is.
  /// @param pass  of the whole image
  [[nodiscard]] PendingPicture draw(const RollingView& view, const ColourPass& pass);

  /// What each pixel's centre sees: objects have their index + 1 as identifier, all else 0.
  /// World surfaces that one can see through (alpha below 1) do not hide what is behind them.
  [[nodiscard]] LabelImages labels(const View& view, const std::vector<Pose>& X_WL,
                                   const LabelPass& pass);

  /// The same of a picture whose rows are taken one after the other: each pixel at its row's time,
  /// in the optical frame of that time.
  [[nodiscard]] LabelImages labels(const RollingView& view, const LabelPass& pass);

  /// How far away [m] along its ray each pixel's centre sees something: CV_32FC1, infinity where
  /// there is nothing but the background, 0 where the lens sees nothing. Glass counts as for
  /// labels().
  [[nodiscard]] cv::Mat distances(const View& view, const std::vector<Pose>& X_WL,
                                  const LinkSelection& drawn);

  /// What the selected links cover as if nothing stood in front of them, past the image's edge too.
  /// In the image, its pixels are those that labels() has for these links alone.
  [[nodiscard]] Silhouette silhouette(const View& view, const std::vector<Pose>& X_WL,
                                      const LinkSelection& links);

  /// The same of a picture whose rows are taken one after the other.
  [[nodiscard]] Silhouette silhouette(const RollingView& view, const LinkSelection& links);

  /// Pixels on which the selected links may be seen: a few more, and none beside them.
  [[nodiscard]] cv::Rect reach(const View& view, const std::vector<Pose>& X_WL,
                               const LinkSelection& links) const;

  /// The same of a picture whose rows are taken one after the other.
  [[nodiscard]] cv::Rect reach(const RollingView& view, const LinkSelection& links) const;

  /// For pictures that were drawn: makes them in the background.
  [[nodiscard]] PictureMakers& makers();

  /// The version of OpenGL: "4.5 (Core Profile) Mesa 22.3.6".
  [[nodiscard]] std::string glVersion() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::render
