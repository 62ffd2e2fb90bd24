#include "render/overlay/background_painter.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "render/gl/picture_upload.h"
#include "render/gl/shader_program.h"
#include "render/overlay/shader_macros.h"
#include "render/pixels/light_picture.h"
#include "render/shaders.h"

namespace synthetic_dataset::render {
namespace {

int share(int length, int numerator, int denominator) {
  const double exact = static_cast<double>(length) * numerator / denominator;
  return std::max(1, static_cast<int>(std::lround(exact)));
}

using Projection = world::BackgroundPicture::Projection;

Eigen::Vector4f vectorOf(const Intrinsics& k) {
  return Eigen::Vector4d(k.fx, k.fy, k.cx, k.cy).cast<float>();
}

const ShaderProgram& made(const GlFunctions& gl, const std::string& fragment_source,
                          const std::string& macros, std::optional<ShaderProgram>& program) {
  if (!program) {
    program.emplace(gl, shaders::kRectanglesVertex, withMacros(fragment_source, macros));
    program->set("picture", static_cast<int>(kDiffuseUnit));
  }
  return *program;
}

/// The size of a picture's part behind an image that a lens shows: the part's own, or twice the
/// image's if that is smaller, so that it is not blurred before it is resampled.
cv::Size sizeThroughLens(const cv::Size& picture, const cv::Size& image) {
  const cv::Size own = partFilling(picture, image).size();
  const cv::Size fine(2 * image.width, 2 * image.height);
  return own.width < fine.width ? own : fine;
}

}  // namespace

cv::Rect partFilling(const cv::Size& picture, const cv::Size& image) {
  const cv::Size part(std::min(picture.width, share(picture.height, image.width, image.height)),
                      std::min(picture.height, share(picture.width, image.height, image.width)));
  return {cv::Point((picture.width - part.width) / 2, (picture.height - part.height) / 2), part};
}

cv::Mat scaledTo(const cv::Size& size, const cv::Mat& picture) {
  if (picture.size() == size) return picture;
  const bool shrinks = size.width < picture.cols || size.height < picture.rows;
  cv::Mat light;
  cv::resize(toLight(picture, PixelMeaning::kColour), light, size, 0.0, 0.0,
             shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
  return fromLight(light, PixelMeaning::kColour);
}

void BackgroundPainter::setPicture(const std::optional<world::BackgroundPicture>& picture) {
  const bool is_same = picture && picture_ && picture->picture == picture_->picture;
  if (!is_same) {
    backdrops_.clear();
    panorama_ = GlTexture();
  }
  picture_ = picture;
}

void BackgroundPainter::paint(const View& view, const View* whole, float exposure,
                              const std::vector<cv::Rect>& regions) {
  const cv::Size size(view.camera.width(), view.camera.height());
  const ShaderProgram& program = picture_->projection == Projection::kPanorama
                                     ? preparePanorama(view)
                                 : whole == nullptr ? prepareBackdrop(size)
                                                    : prepareBackdropThroughLens(view, *whole);
  program.set("gain", exposure * static_cast<float>(picture_->brightness));
  program.set("exposure_later", exposure);
  drawing_.draw(program, regions, size);
}

std::string BackgroundPainter::macros() const { return encoded_ ? kEncodedMacro : ""; }

const ShaderProgram& BackgroundPainter::preparePanorama(const View& view) {
  if (panorama_.name() == 0) {
    panorama_ = uploadPicture(gl_, picture_->picture->pixels, PixelMeaning::kColour, Mipmaps::kAll);
    gl_.TextureParameteri(panorama_.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  gl_.BindTextureUnit(kDiffuseUnit, panorama_.name());
  const ShaderProgram& program = made(gl_, shaders::kPanoramaFragment, macros(), panorama_program_);
  program.set("world_from_camera", Eigen::Matrix4f(view.X_WC.matrix().cast<float>()));
  program.set("intrinsics", vectorOf(view.camera.intrinsics()));
  program.set("yaw", static_cast<float>(picture_->yaw));
  return program;
}

const ShaderProgram& BackgroundPainter::prepareBackdrop(const cv::Size& image) {
  bindBackdrop(image, image);
  return made(gl_, shaders::kBackdropFragment, macros(), backdrop_program_);
}

const ShaderProgram& BackgroundPainter::prepareBackdropThroughLens(const View& face,
                                                                   const View& whole) {
  const CameraModel& camera = whole.camera;
  const cv::Size image(camera.width(), camera.height());
  bindBackdrop(image, sizeThroughLens(picture_->picture->pixels.size(), image));
  const ShaderProgram& program =
      made(gl_, shaders::kBackdropFragment, "#define THROUGH_LENS\n" + macros(), lens_program_);
  const Pose lens_from_face = whole.X_WC.inverse() * face.X_WC;
  program.set("intrinsics", vectorOf(face.camera.intrinsics()));
  program.set("lens_from_face", Eigen::Matrix4f(lens_from_face.matrix().cast<float>()));
  program.set("lens_intrinsics", vectorOf(camera.intrinsics()));
  program.set("image_size", Eigen::Vector4f(static_cast<float>(image.width),
                                            static_cast<float>(image.height), 0.0F, 0.0F));
  std::vector<Eigen::Vector4f> coefficients(4, Eigen::Vector4f::Zero());
  for (std::size_t i = 0; i < Distortion::kMostCoefficients; ++i) {
    coefficients[i / 4][static_cast<Eigen::Index>(i % 4)] =
        static_cast<float>(camera.distortion().coefficients[i]);
  }
  program.set("coefficients", coefficients);
  program.set("lens", static_cast<int>(camera.distortion().model));
  return program;
}

/// Binds the part of the picture that fills an image, scaled to a size.
void BackgroundPainter::bindBackdrop(const cv::Size& image, const cv::Size& size) {
  GlTexture& texture = backdrops_[{image.width, image.height, size.width, size.height}];
  if (texture.name() == 0) {
    const cv::Mat& pixels = picture_->picture->pixels;
    const cv::Mat part = pixels(partFilling(pixels.size(), image));
    texture = uploadPicture(gl_, scaledTo(size, part), PixelMeaning::kColour, Mipmaps::kNone);
    gl_.TextureParameteri(texture.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_.TextureParameteri(texture.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  gl_.BindTextureUnit(kDiffuseUnit, texture.name());
}

}  // namespace synthetic_dataset::render
