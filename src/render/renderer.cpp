#include "render/renderer.h"

#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "render/gl/offscreen_context.h"
#include "render/lens/lens_eye.h"
#include "render/lens/lens_library.h"
#include "render/lens/lens_resampling.h"
#include "render/parts/item_groups.h"
#include "render/picture/lens_painter.h"
#include "render/picture/light_painter.h"
#include "render/picture/painter_cache.h"
#include "render/pixels/pixel_bands.h"
#include "render/shadows/held_casters.h"
#include "render/shadows/shadow_projection.h"

namespace synthetic_dataset::render {
namespace {

/// The regions to draw, cropped to the image; the whole image if none are given.
std::vector<cv::Rect> within(const cv::Rect& image, std::vector<cv::Rect> regions) {
  if (regions.empty()) return {image};
  for (cv::Rect& region : regions) region &= image;
  return regions;
}

}  // namespace

struct Renderer::Impl {
  Impl(const world::Description& description, const std::vector<world::LinkInstance>& links,
       const RenderOptions& render_options)
      : options(render_options),
        lights(description.lights),
        gl(context.gl()),
        draw_list(gl, links, description.simulator, options.glass_in_labels),
        geometry_painter(gl, draw_list),
        light_painter(gl, draw_list, description, options.light),
        shadow_layout(shadowLayout(description.lights, options.shadow_map_size, options.light)),
        shadow_painter(gl, draw_list, shadow_layout),
        edge_smoother(draw_list),
        eye(draw_list, lenses, options.reuse),
        label_painter(gl, draw_list, eye),
        silhouette_painter(gl, draw_list, eye),
        pictures(crew()),
        lens_painter(crew(), eye) {
    gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl.FrontFace(GL_CW);  // the image is drawn with its first row at the bottom
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.Enable(GL_DEPTH_TEST);
  }

  PictureCrew crew() {
    return {gl,
            draw_list,
            lights,
            geometry_painter,
            shadow_painter,
            light_painter,
            edge_smoother,
            options.samples > 1,
            options.reuse};
  }

  /// Pictures that are subtracted from one another have simple light.
  [[nodiscard]] LightDetail detailOf(const ColourPass& pass) const {
    return pass.sampling == Sampling::kSmooth ? options.light : LightDetail::kSimple;
  }

  PendingPicture drawPinhole(const View& view, const std::vector<Pose>& X_WL,
                             const ColourPass& pass, const std::vector<cv::Rect>& regions,
                             const std::vector<ShadowProjection>& shadows,
                             const View* whole = nullptr, const CasterPoses* casters = nullptr) {
    const bool smooth = pass.sampling == Sampling::kSmooth;
    UnfinishedPicture picture = pictures.get(view).paint(
        {view, X_WL, pass.drawn, shadows, pass.exposure, whole, detailOf(pass), casters},
        pass.casting, smooth, regions);
    return [this, picture = std::move(picture)] { return finished(picture, edge_smoother); };
  }

  PendingPicture drawThroughLens(const View& view, const std::vector<Pose>& X_WL,
                                 const ColourPass& pass,
                                 const std::vector<ShadowProjection>& shadows,
                                 const CasterPoses* casters = nullptr) {
    if (!light_painter.hasOverlay(pass.drawn)) {
      return lens_painter.paint(
          {view, X_WL, pass.drawn, shadows, pass.exposure, nullptr, detailOf(pass), casters},
          pass.casting, pass.sampling == Sampling::kSmooth, pass.regions);
    }
    const std::shared_ptr<const LensMap> lens = lenses.get(view.camera);
    const cv::Rect image(0, 0, view.camera.width(), view.camera.height());
    const std::vector<cv::Rect> regions = within(image, pass.regions);
    std::map<std::size_t, PendingPicture> faces;
    const std::vector<View> views = faceViews(*lens, view);
    for (std::size_t face = 0; face < views.size(); ++face) {
      std::vector<cv::Rect> needed;
      for (const cv::Rect& region : regions) needed.push_back(neededOf(*lens, face, region));
      if (boundsOf(needed).empty()) continue;
      faces[face] = drawPinhole(views[face], X_WL, pass, needed, shadows, &view, casters);
    }
    const cv::Scalar background = light_painter.backgroundPixel(pass.exposure);
    const auto resample = pass.sampling == Sampling::kSmooth ? resampleSmooth : resampleCentres;
    return [=, faces = std::move(faces)] {
      cv::Mat picture(image.size(), CV_8UC3, background);
      picture.setTo(cv::Scalar::all(0), lens->face < 0);
      for (const auto& [face, draw] : faces) {
        const cv::Mat drawn = draw();
        for (const cv::Rect& region : regions) resample(*lens, face, drawn, region, picture);
      }
      return picture;
    };
  }

  /// Shadow maps that cover everything that is seen at any of these moments.
  std::vector<ShadowProjection> sharedShadows(const CameraModel& camera,
                                              const std::vector<RollingMoment>& moments,
                                              const ColourPass& pass) {
    std::vector<View> views;
    Bounds casters;
    const Pose* last = nullptr;
    for (const RollingMoment& moment : moments) {
      casters.extend(draw_list.casterBounds(moment.X_WL, pass.casting));
      if (last != nullptr && moment.X_WC.matrix() == last->matrix()) continue;
      last = &moment.X_WC;
      const View view{camera, moment.X_WC};
      const bool distorted = hasDistortion(camera);
      for (const View& face :
           distorted ? faceViews(*lenses.get(camera), view) : std::vector<View>{view}) {
        views.push_back(face);
      }
    }
    return shadowProjections(lights, views, casters, options.shadow_distance, shadow_layout,
                             detailOf(pass));
  }

  /// Draws each band at the time of its middle row.
  static PendingPicture drawInBands(const RollingView& view, const ColourPass& pass,
                                    Renderer& renderer) {
    cv::Mat picture(view.camera.height(), view.camera.width(), CV_8UC3);
    for (int band = 0; band < view.bands; ++band) {
      const cv::Rect rows = view.rowsOf(band);
      const RollingMoment moment = view.at(rows.y + 0.5 * (rows.height - 1));
      ColourPass of_band = pass;
      of_band.regions = {rows};
      cv::Mat here = picture(rows);
      renderer.colour({view.camera, moment.X_WC}, moment.X_WL, of_band)(rows).copyTo(here);
    }
    return [picture] { return picture; };
  }

  RenderOptions options;
  std::vector<world::Light> lights;
  std::int64_t look_revision = 0;

  OffscreenContext context;  // before everything that lives in it
  const GlFunctions& gl;
  DrawList draw_list;
  GeometryPainter geometry_painter;
  LightPainter light_painter;
  ShadowLayout shadow_layout;
  ShadowPainter shadow_painter;
  EdgeSmoother edge_smoother;
  LensLibrary lenses;
  LensEye eye;
  LabelPainter label_painter;
  SilhouettePainter silhouette_painter;
  PainterCache pictures;
  LensPainter lens_painter;
  PictureMakers makers;  ///< last: the pictures they make need the other members
};

Renderer::Renderer(const world::Description& description,
                   const std::vector<world::LinkInstance>& links, const RenderOptions& options)
    : impl_(std::make_unique<Impl>(description, links, options)) {}

Renderer::~Renderer() = default;

PictureMakers& Renderer::makers() { return impl_->makers; }

void Renderer::setLook(const world::Look& look) {
  Impl& impl = *impl_;
  impl.lights = look.lights;
  impl.draw_list.setMaterials(look.materials);
  impl.light_painter.setLook(look);
  impl.pictures.forget();
  impl.eye.forget();
  impl.lens_painter.forget();
  ++impl.look_revision;
}

std::int64_t Renderer::lookRevision() const { return impl_->look_revision; }

cv::Mat Renderer::colour(const View& view, const std::vector<Pose>& X_WL, const ColourPass& pass) {
  return draw(view, X_WL, pass)();
}

PendingPicture Renderer::draw(const View& view, const std::vector<Pose>& X_WL,
                              const ColourPass& pass) {
  Impl& impl = *impl_;
  const bool distorted = hasDistortion(view.camera);
  const auto shadows = shadowProjections(
      impl.lights,
      distorted ? faceViews(*impl.lenses.get(view.camera), view) : std::vector<View>{view},
      impl.draw_list.casterBounds(X_WL, pass.casting), impl.options.shadow_distance,
      impl.shadow_layout, impl.detailOf(pass));
  return distorted ? impl.drawThroughLens(view, X_WL, pass, shadows)
                   : impl.drawPinhole(view, X_WL, pass, pass.regions, shadows);
}

void Renderer::drawExposure(const CameraModel& camera, const std::vector<RollingMoment>& moments,
                            const ColourPass& pass,
                            const std::function<void(PendingPicture)>& see) {
  Impl& impl = *impl_;
  const auto shadows = impl.sharedShadows(camera, moments, pass);
  std::vector<const std::vector<Pose>*> poses;
  for (const RollingMoment& moment : moments) poses.push_back(&moment.X_WL);
  // Less than the width of shadows' edges; and the pictures are averaged.
  constexpr double kHeld = 2.0;  // [texel]
  const auto held = heldForShadows(impl.draw_list.items(), poses, shadows, kHeld);
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const View view{camera, moments[i].X_WC};
    const std::vector<Pose>& X_WL = moments[i].X_WL;
    see(hasDistortion(camera)
            ? impl.drawThroughLens(view, X_WL, pass, shadows, &held[i])
            : impl.drawPinhole(view, X_WL, pass, pass.regions, shadows, nullptr, &held[i]));
  }
}

PendingPicture Renderer::draw(const RollingView& view, const ColourPass& pass) {
  Impl& impl = *impl_;
  if (impl.light_painter.hasOverlay(pass.drawn)) return impl.drawInBands(view, pass, *this);
  const RollingMoment middle = view.middle();
  const View at_middle{view.camera, middle.X_WC};
  const auto shadows = impl.sharedShadows(view.camera, view.moments, pass);
  return impl.lens_painter.paintInRows(
      {at_middle, middle.X_WL, pass.drawn, shadows, pass.exposure, nullptr, impl.detailOf(pass)},
      view, pass.casting, pass.sampling == Sampling::kSmooth);
}

LabelImages Renderer::labels(const View& view, const std::vector<Pose>& X_WL,
                             const LabelPass& pass) {
  Impl& impl = *impl_;
  const bool needs_own_pass = !impl.options.reuse || hasDistortion(view.camera) || pass.normals ||
                              impl.draw_list.hasGlassInLabels(pass.drawn);
  if (needs_own_pass) return impl.label_painter.paint(view, X_WL, pass);
  const GeometryImages images = impl.pictures.get(view).geometry(view, X_WL, pass.drawn);
  return labelsOf(images, impl.draw_list, view.camera.intrinsics(), pass);
}

LabelImages Renderer::labels(const RollingView& view, const LabelPass& pass) {
  return impl_->label_painter.paint(view, pass);
}

cv::Mat Renderer::distances(const View& view, const std::vector<Pose>& X_WL,
                            const LinkSelection& drawn) {
  LabelPass pass{drawn};
  pass.range = true;
  const LabelImages images = labels(view, X_WL, pass);
  cv::Mat distances = images.range.clone();
  distances.setTo(std::numeric_limits<double>::infinity(), images.range == 0.0);
  if (hasDistortion(view.camera)) {
    distances.setTo(0.0, impl_->lenses.get(view.camera)->face < 0);
  }
  return distances;
}

Silhouette Renderer::silhouette(const View& view, const std::vector<Pose>& X_WL,
                                const LinkSelection& links) {
  const PicturePainter* drawn = hasDistortion(view.camera) ? nullptr : impl_->pictures.find(view);
  return impl_->silhouette_painter.paint(
      view, X_WL, links, drawn != nullptr ? drawn->covered(view, X_WL, links) : std::nullopt);
}

Silhouette Renderer::silhouette(const RollingView& view, const LinkSelection& links) {
  return impl_->silhouette_painter.paint(view, links);
}

cv::Rect Renderer::reach(const View& view, const std::vector<Pose>& X_WL,
                         const LinkSelection& links) const {
  return boundsOf(regionsOf(impl_->draw_list.items(), view, X_WL,
                            [&](const DrawItem& item) { return links[item.link]; }));
}

cv::Rect Renderer::reach(const RollingView& view, const LinkSelection& links) const {
  cv::Rect all;  // in OpenCV the union with an empty rectangle is the other rectangle
  for (const RollingMoment& moment : view.moments) {
    all |= reach({view.camera, moment.X_WC}, moment.X_WL, links);
  }
  return all;
}

std::string Renderer::glVersion() const { return impl_->context.version(); }

}  // namespace synthetic_dataset::render
