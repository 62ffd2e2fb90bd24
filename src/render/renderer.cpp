#include "render/renderer.h"

#include <map>
#include <utility>

#include "render/colour_painter.h"
#include "render/kept_picture.h"
#include "render/lens_library.h"
#include "render/lens_resampling.h"
#include "render/light_setup.h"
#include "render/osmesa_context.h"
#include "render/shadow_painter.h"
#include "sensor/srgb.h"

namespace synthetic_dataset::render {
namespace {

using ImageSize = std::pair<int, int>;

ImageSize sizeOf(const CameraModel& camera) { return {camera.width(), camera.height()}; }

}  // namespace

struct Renderer::Impl {
  Impl(const world::Description& description, const std::vector<world::LinkInstance>& links,
       const RenderOptions& render_options)
      : options(render_options),
        lights(description.lights),
        gl(context.gl()),
        draw_list(gl, links),
        colour_painter(gl, draw_list, description),
        shadow_painter(gl, draw_list, options.shadow_map_size, shadowCount(description.lights)),
        label_painter(gl, draw_list, lenses),
        silhouette_painter(gl, draw_list, lenses) {
    gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl.FrontFace(GL_CW);  // the image is drawn with its first row at the bottom
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.Enable(GL_DEPTH_TEST);
  }

  /// @param region  the part that is drawn
  cv::Mat drawPinhole(const View& view, const std::vector<Pose>& X_WL, const ColourPass& pass,
                      const std::optional<cv::Rect>& region,
                      const std::vector<ShadowProjection>& shadows) {
    const ColourTarget& target = colourTarget(view.camera, pass.sampling);
    const Eigen::Vector3f exposed = pass.exposure * colour_painter.background();
    target.begin(exposed.data());
    if (region) {
      gl.Enable(GL_SCISSOR_TEST);
      gl.Scissor(region->x, region->y, region->width, region->height);
    }
    colour_painter.paint({view, X_WL, pass.drawn, shadows, pass.exposure},
                         shadow_painter.texture());
    gl.Disable(GL_SCISSOR_TEST);
    return target.read();
  }

  /// The same of a whole picture, with what can be kept of the one before.
  cv::Mat drawKept(const View& view, const std::vector<Pose>& X_WL, const ColourPass& pass,
                   const std::vector<ShadowProjection>& shadows) {
    const ColourTarget& target = colourTarget(view.camera, pass.sampling);
    const Eigen::Vector3f exposed = pass.exposure * colour_painter.background();
    KeptPicture& picture = kept_pictures
                               .try_emplace(sizeOf(view.camera), gl, draw_list, lights,
                                            shadow_painter, colour_painter, target)
                               .first->second;
    picture.paint({view, X_WL, pass.drawn, shadows, pass.exposure}, pass.casting, exposed.data());
    return target.read();
  }

  cv::Mat drawThroughLens(const View& view, const std::vector<Pose>& X_WL, const ColourPass& pass,
                          const std::vector<ShadowProjection>& shadows) {
    const LensMap& lens = lenses.get(view.camera);
    const cv::Rect image(0, 0, view.camera.width(), view.camera.height());
    const cv::Rect region = pass.region.value_or(image) & image;
    const auto encoded = [&](Eigen::Index i) {
      return sensor::srgbFromLinear(pass.exposure * colour_painter.background()[i]);
    };
    cv::Mat picture(image.size(), CV_8UC3, cv::Scalar(encoded(2), encoded(1), encoded(0)));
    picture.setTo(cv::Scalar::all(0), lens.face < 0);
    const std::vector<View> views = faceViews(lens, view);
    for (std::size_t face = 0; face < views.size(); ++face) {
      const cv::Rect needed = neededOf(lens, face, region);
      if (needed.empty()) continue;
      const cv::Mat drawn = drawPinhole(views[face], X_WL, pass, needed, shadows);
      const bool smooth = pass.sampling == Sampling::kSmooth;
      (smooth ? resampleSmooth : resampleCentres)(lens, face, drawn, region, picture);
    }
    return picture;
  }

  const ColourTarget& colourTarget(const CameraModel& camera, Sampling sampling) {
    auto& targets = sampling == Sampling::kSmooth ? smooth_targets : centre_targets;
    const int samples = sampling == Sampling::kSmooth ? options.samples : 1;
    return targets.try_emplace(sizeOf(camera), gl, camera.width(), camera.height(), samples)
        .first->second;
  }

  RenderOptions options;
  std::vector<world::Light> lights;

  OsmesaContext context;  // before all that lives in it
  const GlFunctions& gl;
  DrawList draw_list;
  ColourPainter colour_painter;
  ShadowPainter shadow_painter;
  LensLibrary lenses;
  LabelPainter label_painter;
  SilhouettePainter silhouette_painter;
  std::map<ImageSize, ColourTarget> smooth_targets;
  std::map<ImageSize, ColourTarget> centre_targets;
  std::map<ImageSize, KeptPicture> kept_pictures;  ///< in smooth_targets
};

Renderer::Renderer(const world::Description& description,
                   const std::vector<world::LinkInstance>& links, const RenderOptions& options)
    : impl_(std::make_unique<Impl>(description, links, options)) {}

Renderer::~Renderer() = default;

cv::Mat Renderer::colour(const View& view, const std::vector<Pose>& X_WL, const ColourPass& pass) {
  Impl& impl = *impl_;
  const bool distorted = hasDistortion(view.camera);
  const auto shadows = shadowProjections(
      impl.lights,
      distorted ? faceViews(impl.lenses.get(view.camera), view) : std::vector<View>{view},
      impl.draw_list.casterBounds(X_WL, pass.casting), impl.options.shadow_distance,
      impl.options.shadow_map_size);
  if (!distorted && !pass.region && pass.sampling == Sampling::kSmooth) {
    return impl.drawKept(view, X_WL, pass, shadows);
  }
  impl.shadow_painter.paint(shadows, X_WL, pass.casting);
  return distorted ? impl.drawThroughLens(view, X_WL, pass, shadows)
                   : impl.drawPinhole(view, X_WL, pass, pass.region, shadows);
}

LabelImages Renderer::labels(const View& view, const std::vector<Pose>& X_WL,
                             const LabelPass& pass) {
  return impl_->label_painter.paint(view, X_WL, pass);
}

Silhouette Renderer::silhouette(const View& view, const std::vector<Pose>& X_WL,
                                const LinkSelection& links) {
  return impl_->silhouette_painter.paint(view, X_WL, links);
}

std::string Renderer::glVersion() const { return impl_->context.version(); }

}  // namespace synthetic_dataset::render
