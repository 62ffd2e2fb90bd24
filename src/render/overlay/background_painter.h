#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include "render/gl/gl_object.h"
#include "render/gl/rectangle_drawing.h"
#include "render/gl/shader_program.h"
#include "render/view.h"
#include "world/look.h"

namespace synthetic_dataset::render {

/// The largest centred part of a picture that has an image's aspect ratio, to a pixel.
[[nodiscard]] cv::Rect partFilling(const cv::Size& picture, const cv::Size& image);

/// Scales a picture to a size: with means of light if it gets smaller. Returns the pixels as they
/// are if it has that size already.
/// @param picture  CV_8UC4, sRGB-encoded, or CV_32FC4, linear light; opaque
[[nodiscard]] cv::Mat scaledTo(const cv::Size& size, const cv::Mat& picture);

/// Paints a picture where nothing is drawn: one that fills the image, or a panorama.
class BackgroundPainter {
 public:
  /// @param encoded  whether what is painted is encoded and exposed later (shown.glsl)
  BackgroundPainter(const GlFunctions& gl, bool encoded)
      : gl_(gl), encoded_(encoded), drawing_(gl) {}

  /// Sets the picture that is painted from now on, or none.
  void setPicture(const std::optional<world::BackgroundPicture>& picture);

  [[nodiscard]] bool hasPicture() const { return picture_.has_value(); }

  /// Fills the pixels of the bound target that are still at the far plane.
  /// @param whole  the view of the lens of which `view` is a face; null if it is not a face
  /// @param exposure  multiplies the picture's light
  /// @param regions  of the target; only these are painted
  void paint(const View& view, const View* whole, float exposure,
             const std::vector<cv::Rect>& regions);

 private:
  /// Each returns its program, with the picture bound to its texture unit.
  [[nodiscard]] const ShaderProgram& preparePanorama(const View& view);
  [[nodiscard]] const ShaderProgram& prepareBackdrop(const cv::Size& image);
  [[nodiscard]] const ShaderProgram& prepareBackdropThroughLens(const View& face,
                                                                const View& whole);

  /// The macros of the programs.
  [[nodiscard]] std::string macros() const;

  void bindBackdrop(const cv::Size& image, const cv::Size& size);

  const GlFunctions& gl_;
  bool encoded_;
  RectangleDrawing drawing_;
  std::optional<world::BackgroundPicture> picture_;
  std::map<std::array<int, 4>, GlTexture> backdrops_;  ///< by the image's size and their own
  GlTexture panorama_;                                 ///< empty until it is needed
  std::optional<ShaderProgram> panorama_program_;      ///< each is made when it is needed
  std::optional<ShaderProgram> backdrop_program_;
  std::optional<ShaderProgram> lens_program_;
};

}  // namespace synthetic_dataset::render
