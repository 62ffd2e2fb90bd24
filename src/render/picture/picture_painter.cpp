#include "render/picture/picture_painter.h"

#include <algorithm>
#include <utility>

#include "render/edges/edge_pixels.h"
#include "render/parts/item_groups.h"
#include "render/picture/changed_pixels.h"
#include "render/picture/possible_changes.h"
#include "render/pixels/pixel_bands.h"
#include "render/pixels/srgb.h"
#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::render {
namespace {

/// The lens and its pose if a face of it is drawn, as a background picture is distorted
/// accordingly.
std::vector<double> lensOf(const ColourScene& scene) {
  if (scene.whole == nullptr) return {};
  const CameraModel& camera = scene.whole->camera;
  const Intrinsics& k = camera.intrinsics();
  const auto& distortion = camera.distortion().coefficients;
  const Eigen::Matrix4d& place = scene.whole->X_WC.matrix();
  std::vector<double> lens = {static_cast<double>(camera.width()),
                              static_cast<double>(camera.height()),
                              k.fx,
                              k.fy,
                              k.cx,
                              k.cy,
                              static_cast<double>(camera.distortion().model)};
  lens.insert(lens.end(), distortion.begin(), distortion.end());
  lens.insert(lens.end(), place.data(), place.data() + place.size());
  return lens;
}

}  // namespace

cv::Mat finished(const UnfinishedPicture& picture, const EdgeSmoother& smoother) {
  cv::Mat result = picture.elsewhere.empty() ? cv::Mat(picture.pixels.size(), CV_8UC3)
                                             : picture.elsewhere.clone();
  const SeenSurfaces& seen = picture.unlit.seen;
  const cv::Mat light = picture.unlit.light();
  for (const cv::Rect& region : picture.regions) {
    cv::Mat pixels = result(region);
    encodeSrgb(light(region - seen.place.tl()), picture.pixels(region), pixels);
  }
  if (picture.edges) {
    smoother.smooth(*picture.edges, {seen.geometry, light, seen.place}, picture.regions,
                    picture.pixels, result);
  }
  return result;
}

bool PicturePainter::GeometryKey::operator==(const GeometryKey& other) const {
  return clip_from_camera == other.clip_from_camera && X_WC == other.X_WC && drawn == other.drawn;
}

bool PicturePainter::LightKey::operator==(const LightKey& other) const {
  return shadows == other.shadows && casting == other.casting && exposure == other.exposure &&
         lens == other.lens;
}

bool PicturePainter::Content::has(const Content& other) const {
  return drawn == other.drawn && X_WL == other.X_WL && (pixels & other.pixels) == other.pixels;
}

PicturePainter::PicturePainter(const PictureCrew& crew, const cv::Size& size)
    : crew_(crew),
      image_(cv::Point(), size),
      geometry_(makeGeometryBuffer(crew.gl, size, crew.geometry_painter.planes())),
      overlay_(geometry_, {GL_RGBA16F}) {}

void PicturePainter::forget() {
  forgetContent();
  bits_ = {};
  geometry_key_ = {};
  keeps_geometry_ = false;
  covered_.clear();
  for (KeptPicture& kept : kept_pictures_) kept = {};
}

/// To be called before geometry_ is changed.
void PicturePainter::forgetContent() {
  content_.reset();
  images_ = {};
}

bool PicturePainter::drewFrom(const View& view) const {
  return image_.size() == cv::Size(view.camera.width(), view.camera.height()) &&
         geometry_key_.X_WC == view.X_WC.matrix() &&
         geometry_key_.clip_from_camera == clipFromCamera(view.camera);
}

UnfinishedPicture PicturePainter::paint(const ColourScene& scene, const LinkSelection& casting,
                                        bool smooth, const std::vector<cv::Rect>& regions) {
  const cv::Mat wanted = wantedPixels(regions);
  if (!regions.empty() && maskBounds(wanted).empty()) {
    return {plainPicture(scene.exposure), {}, {}, {}, std::nullopt};
  }
  const cv::Rect pixels = neededFor(scene, regions);
  drawGeometry(scene.view, scene.X_WL, scene.drawn, pixels);
  const KeptPicture* kept = keptPicture(scene, casting, smooth);
  if (kept == nullptr) {
    paintShadows(scene, casting, pixels);
    UnfinishedPicture picture = light(scene, scene.drawn, true, smooth, wanted);
    if (!regions.empty()) picture.elsewhere = plainPicture(scene.exposure);
    return picture;
  }
  drawGeometry(scene.view, scene.X_WL, scene.drawn, pixels);
  const cv::Mat changed = changedPixels(scene, casting, kept->edges, wanted, regions.empty());
  UnfinishedPicture picture = light(scene, scene.drawn, true, smooth, changed);
  picture.elsewhere = kept->pixels;
  if (!regions.empty()) {
    picture.elsewhere = plainPicture(scene.exposure);
    kept->pixels.copyTo(picture.elsewhere, wanted);
  }
  return picture;
}

/// Up to how many pixels away what is seen affects a pixel's light.
int PicturePainter::reach(const ColourScene& scene) const {
  return scene.detail == LightDetail::kFull ? occlusionReach(image_.size()) : 0;
}

/// The pixels that are needed to compute those of some regions; without regions, all. Edges are
/// found by the pixels beside them, from which they take their light.
cv::Rect PicturePainter::neededFor(const ColourScene& scene,
                                   const std::vector<cv::Rect>& regions) const {
  if (regions.empty()) return image_;
  return grown(boundsOf(regions) & image_, 2 + reach(scene)) & image_;
}

/// CV_8UC1: 255 for the pixels of the regions; if there are no regions, for all pixels.
cv::Mat PicturePainter::wantedPixels(const std::vector<cv::Rect>& regions) const {
  if (regions.empty()) return {image_.size(), CV_8UC1, cv::Scalar(255)};
  cv::Mat wanted = cv::Mat::zeros(image_.size(), CV_8UC1);
  for (const cv::Rect& region : regions) wanted(region & image_).setTo(255);
  return wanted;
}

/// Draws the shadow maps as far as they matter for some pixels.
void PicturePainter::paintShadows(const ColourScene& scene, const LinkSelection& casting,
                                  const cv::Rect& pixels) {
  std::vector<LinkSelection> moving;
  if (pixels != image_) {
    moving = castersOnto(pixels, crew_.draw_list.items(), scene.view, scene.X_WL, scene.drawn,
                         casting, crew_.lights, scene.shadows);
  }
  crew_.shadow_painter.paint(scene.shadows, scene.X_WL, casting, moving, scene.casters);
}

/// Draws the shadow maps, and finds which pixels differ from those of the kept picture.
/// @param edges  of the kept picture
/// @param wanted  the pixels that are wanted, possibly all
cv::Mat PicturePainter::changedPixels(const ColourScene& scene, const LinkSelection& casting,
                                      const cv::Mat& edges, const cv::Mat& wanted, bool wants_all) {
  const PossibleChanges regions =
      possibleChanges(crew_.draw_list.items(), scene.view, scene.X_WL, scene.drawn, casting,
                      crew_.lights, scene.shadows);
  // Pixels just beside the wanted ones may turn them into edges.
  cv::Mat possible = regions.all();
  if (!wants_all) possible &= withPixelsAround(wanted, 1 + reach(scene));
  const cv::Rect place = maskBounds(possible);
  if (place.empty()) return possible;
  paintShadows(scene, casting, wants_all ? image_ : place);
  const ChangedPixels changed(crew_.draw_list, scene.view);
  cv::Mat pixels = changed.find(regions, seenAround(place, scene),
                                crew_.shadow_painter.changedTexels(scene.shadows), edges);
  if (!wants_all) pixels &= wanted;
  return pixels;
}

GeometryImages PicturePainter::geometry(const View& view, const std::vector<Pose>& X_WL,
                                        const LinkSelection& drawn) {
  drawGeometry(view, X_WL, drawn, image_);
  return read(image_);
}

/// Reads what geometry_ shows. Usually the whole picture is read, as labels need it next.
GeometryImages PicturePainter::read(const cv::Rect& pixels) {
  if (content_ && content_->pixels != image_) return readGeometry(geometry_, pixels);
  if (images_.items.empty() && keeps_geometry_) {
    readOverKept();
  } else if (images_.items.empty()) {
    if (2 * pixels.area() < image_.area()) return readGeometry(geometry_, pixels);
    images_ = readGeometry(geometry_, image_);
  }
  return {images_.items(pixels), images_.depth(pixels), {}};
}

/// Reads only where geometry_ differs from the kept geometry; the rest has been read before.
void PicturePainter::readOverKept() {
  if (kept_images_.items.empty()) kept_images_ = readGeometry(*kept_geometry_, image_);
  images_ = {kept_images_.items.clone(), kept_images_.depth.clone(), {}};
  for (const cv::Rect& region : covered_) {
    const GeometryImages here = readGeometry(geometry_, region);
    here.items.copyTo(images_.items(region));
    here.depth.copyTo(images_.depth(region));
  }
}

std::optional<CoveredPixels> PicturePainter::covered(const View& view,
                                                     const std::vector<Pose>& X_WL,
                                                     const LinkSelection& links) const {
  const auto isThere = [](const Pose& pose, const Eigen::Matrix4d& drawn) {
    return pose.matrix() == drawn;
  };
  const bool is_drawn =
      content_ && content_->pixels == image_ && drewFrom(view) &&
      std::equal(X_WL.begin(), X_WL.end(), content_->X_WL.begin(), content_->X_WL.end(), isThere);
  const auto place = is_drawn ? bits_.find(links) : std::nullopt;
  if (!place) return std::nullopt;
  return CoveredPixels{place->pixels, (geometry_.readStencil(place->pixels) & place->bit) != 0};
}

PicturePainter::LightKey PicturePainter::lightKey(const ColourScene& scene,
                                                  const LinkSelection& casting) const {
  LightKey key{{}, crew_.draw_list.standing(casting), scene.exposure, lensOf(scene)};
  for (const ShadowProjection& shadow : scene.shadows) {
    key.shadows.push_back(shadow.shadow_from_world);
  }
  return key;
}

/// Makes geometry_ show these links.
/// @param pixels  the pixels to draw; all others are undefined
void PicturePainter::drawGeometry(const View& view, const std::vector<Pose>& X_WL,
                                  const LinkSelection& drawn, const cv::Rect& pixels) {
  Content content{drawn, {}, pixels};
  for (const Pose& pose : X_WL) content.X_WL.push_back(pose.matrix());
  GeometryKey key{clipFromCamera(view.camera), view.X_WC.matrix(), crew_.draw_list.standing(drawn)};
  const bool came_before = crew_.keeps && geometry_key_ == key;
  if (came_before && content_ && content_->has(content)) return;
  forgetContent();
  if (came_before) {
    drawStandingGeometry(view, X_WL, drawn);
  } else {
    // The view may not recur: what is to be kept is drawn only when it does.
    geometry_key_ = std::move(key);
    keeps_geometry_ = false;
    for (KeptPicture& kept : kept_pictures_) kept = {};
    beginGeometry(geometry_);
    crew_.geometry_painter.paint(view, X_WL, drawn, true, {}, pixels);
  }
  // For a first picture, the stencil would save no time, as OpenGL compiles shaders for it.
  bits_ = crew_.keeps && has_drawn_ ? SilhouetteBits(crew_.draw_list, view, X_WL, drawn)
                                    : SilhouetteBits();
  has_drawn_ = true;
  geometry_.bind();
  crew_.geometry_painter.paint(view, X_WL, drawn, false, bits_, pixels);
  covered_ = regionsOf(crew_.draw_list.items(), view, X_WL, [&](const DrawItem& item) {
    return drawn[item.link] && !item.stands_still;
  });
  for (cv::Rect& region : covered_) region &= pixels;
  content_ = std::move(content);
  crew_.gl.Flush();  // makes Mesa's threads begin now, not when the result is read
}

/// Makes geometry_ show only what never moves.
void PicturePainter::drawStandingGeometry(const View& view, const std::vector<Pose>& X_WL,
                                          const LinkSelection& drawn) {
  forgetContent();
  if (keeps_geometry_) {
    for (const cv::Rect& region : covered_) {
      if (!region.empty()) kept_geometry_->copyTo(geometry_, region);
    }
    covered_.clear();
    return;
  }
  beginGeometry(geometry_);
  crew_.geometry_painter.paint(view, X_WL, drawn, true, {}, image_);
  if (!kept_geometry_) {
    kept_geometry_.emplace(
        makeGeometryBuffer(crew_.gl, image_.size(), crew_.geometry_painter.planes()));
  }
  geometry_.copyTo(*kept_geometry_, image_);
  kept_images_ = {};
  keeps_geometry_ = true;
  covered_.clear();
}

/// The picture of what never moves; null until it is known to be needed again.
const PicturePainter::KeptPicture* PicturePainter::keptPicture(const ColourScene& scene,
                                                               const LinkSelection& casting,
                                                               bool smooth) {
  if (!crew_.keeps) return nullptr;
  KeptPicture& kept = kept_pictures_.at(smooth ? 1 : 0);
  LightKey key = lightKey(scene, casting);
  if (!(kept.key == key)) {
    kept = {std::move(key), {}, {}};
    return nullptr;
  }
  if (!kept.pixels.empty()) return &kept;
  drawStandingGeometry(scene.view, scene.X_WL, scene.drawn);
  crew_.shadow_painter.paintStanding(scene.shadows, scene.X_WL, casting);
  UnfinishedPicture picture = light(scene, crew_.draw_list.standing(scene.drawn), false, smooth,
                                    cv::Mat(image_.size(), CV_8UC1, cv::Scalar(255)));
  kept.pixels = finished(picture, crew_.edge_smoother);
  if (picture.edges) {
    kept.edges = EdgePixels(picture.unlit.seen.geometry, image_, {image_}, picture.pixels,
                            scene.view.camera.intrinsics())
                     .mask(image_.size());
  }
  return &kept;
}

/// Gathers what the light of pixels is computed from.
/// @param seen  the links that were drawn
/// @param pixels  CV_8UC1: not 0 for the pixels to light
/// @return a picture without `elsewhere`
UnfinishedPicture PicturePainter::light(const ColourScene& scene, const LinkSelection& seen,
                                        bool see_through, bool smooth, const cv::Mat& pixels) {
  UnfinishedPicture picture;
  picture.pixels = pixels;
  picture.regions = bandsOf(pixels);
  if (picture.regions.empty()) return picture;
  smooth = smooth && crew_.smooths;
  // Edges take their light from the pixels around them.
  const cv::Mat wanted = smooth ? withPixelsAround(pixels) : pixels;
  const std::vector<cv::Rect> lit = smooth ? bandsOf(wanted) : picture.regions;
  const bool is_full = scene.detail == LightDetail::kFull;
  const cv::Mat known = is_full ? withPixelsAround(wanted, kOcclusionSmoothing) : wanted;
  const std::vector<cv::Rect> bands = bandsOf(known, kCoarseBand);
  const cv::Rect place = is_full ? boundsOf(bands) : boundsOf(lit);
  SeenSurfaces surfaces{read(place), readSurfaces(geometry_, place, bands), place};
  surfaces.geometry.normals = surfaces.surfaces.vertexNormals();
  if (is_full) surfaces.occluders = occludersAround(place, scene);
  picture.unlit = crew_.light_painter.paint(scene, surfaces, crew_.shadow_painter, overlay_,
                                            see_through, lit, wanted);
  if (smooth) picture.edges = EdgeScene{scene.view, scene.X_WL, seen};
  return picture;
}

/// What some pixels see, and the pixels around them that affect their light.
SeenGeometry PicturePainter::seenAround(const cv::Rect& place, const ColourScene& scene) {
  if (scene.detail == LightDetail::kSimple) return {read(place), place};
  const cv::Rect around = grown(place, reach(scene)) & content_->pixels;
  SeenGeometry seen{read(around), around};
  seen.reaches =
      occlusionReaches({seen.images.depth, around, image_.size(), scene.view.camera.intrinsics()});
  return seen;
}

/// The surfaces that may occlude the ambient light of what is seen in some pixels.
Occluders PicturePainter::occludersAround(const cv::Rect& place, const ColourScene& scene) {
  const cv::Rect around = grown(place, reach(scene)) & image_;
  return {read(around).depth, around, image_.size(), scene.view.camera.intrinsics()};
}

cv::Mat PicturePainter::plainPicture(float exposure) const {
  return {image_.size(), CV_8UC3, crew_.light_painter.backgroundPixel(exposure)};
}

}  // namespace synthetic_dataset::render
