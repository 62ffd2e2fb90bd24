#include "render/picture/lens_painter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/core.hpp>

#include "render/edges/edge_pixels.h"
#include "render/lens/lens_edges.h"
#include "render/parts/item_groups.h"
#include "render/picture/changed_pixels.h"
#include "render/pixels/pixel_bands.h"
#include "render/pixels/srgb.h"
#include "render/recent_views.h"
#include "render/shadows/held_casters.h"
#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::render {
namespace {

cv::Mat allPixels(const cv::Size& size) { return {size, CV_8UC1, cv::Scalar(255)}; }

/// A picture through a lens whose light is still to be computed.
struct UnlitLens {
  std::shared_ptr<const LensSight> sight;
  cv::Mat elsewhere;              ///< CV_8UC3: all pixels that are not in `pixels`
  cv::Mat pixels;                 ///< CV_8UC1: 255 for the pixels to light
  std::vector<cv::Rect> regions;  ///< contain all of `pixels`
  cv::Mat wanted;                 ///< CV_8UC1: `pixels`, and their neighbours if edges are smooth
  std::vector<cv::Rect> wanted_regions;
  cv::Mat known;                 ///< CV_8UC1: not 0 for pixels whose surfaces the wanted ones need
  cv::Rect place;                ///< contains all of `known`
  std::vector<UnlitPixels> lit;  ///< all, or one per band; their surfaces are still to be found
  EdgeScene scene;
  StandingSurfaces standing = {};
  GeometryPlanes planes = {};
  bool is_classic = false;
  bool smooth = false;
};

/// A part of images, given in the images' coordinates.
SurfaceImages cut(const SurfaceImages& images, const cv::Rect& part) {
  const auto of = [&](const cv::Mat& image) { return image.empty() ? image : image(part); };
  return {of(images.base_roughness), of(images.normal_metalness), of(images.faces),
          of(images.glows)};
}

/// The light of all of `picture.lit`: CV_16UC4 of the place.
cv::Mat lightOf(const UnlitLens& picture, const SurfaceImages& surfaces) {
  cv::Mat light;
  for (UnlitPixels unlit : picture.lit) {
    const cv::Rect here = unlit.seen.place - picture.place.tl();
    unlit.seen.surfaces = cut(surfaces, here);
    unlit.seen.geometry.normals = unlit.seen.surfaces.vertexNormals();
    const cv::Mat found = unlit.light();
    if (picture.lit.size() == 1) return found;
    if (light.empty()) light.create(picture.place.size(), CV_16UC4);
    for (const cv::Rect& region : unlit.regions) {
      cv::Mat there = light(region - picture.place.tl());
      found(region - unlit.seen.place.tl()).copyTo(there);
    }
  }
  return light;
}

SurfaceImages surfacesOf(const UnlitLens& picture) {
  return surfacesOf(*picture.sight, picture.planes, picture.is_classic, picture.place,
                    picture.known, picture.standing);
}

/// @param edges  receives the mask of smoothed pixels, if not null
cv::Mat finishedThroughLens(const UnlitLens& picture, const SurfaceImages& surfaces,
                            const DrawList& draw_list, cv::Mat* edges) {
  cv::Mat result = picture.elsewhere.clone();
  const LensSight& sight = *picture.sight;
  const cv::Mat light = lightOf(picture, surfaces);
  for (const cv::Rect& region : picture.regions) {
    cv::Mat pixels = result(region);
    encodeSrgb(light(region - picture.place.tl()), picture.pixels(region), pixels);
  }
  if (picture.smooth) {
    const GeometryImages geometry{sight.items(picture.place), sight.distance(picture.place),
                                  surfaces.vertexNormals()};
    const EdgePixels found(geometry, picture.place, picture.regions, picture.pixels,
                           picture.scene.view.camera.intrinsics(), sight.lens->rays);
    smoothEdges(draw_list, picture.scene, sight, {geometry, light, picture.place}, found, result);
    if (edges != nullptr) *edges = found.mask(result.size());
  }
  result.setTo(cv::Scalar::all(0), sight.lens->face < 0);
  return result;
}

PendingPicture pending(UnlitLens picture, const DrawList& draw_list) {
  return [picture = std::move(picture), &draw_list]() -> cv::Mat {
    if (picture.regions.empty()) return picture.elsewhere.clone();
    return finishedThroughLens(picture, surfacesOf(picture), draw_list, nullptr);
  };
}

}  // namespace

bool LensPainter::Key::operator==(const Key& other) const {
  return lens == other.lens && X_WC == other.X_WC && drawn == other.drawn &&
         casting == other.casting && shadows == other.shadows && exposure == other.exposure &&
         detail == other.detail && smooth == other.smooth;
}

namespace {

Occluders occludersOf(const LensSight& sight, const CameraModel& camera) {
  const cv::Size size = sight.items.size();
  return {sight.distance, {cv::Point(), size}, size, camera.intrinsics(), sight.lens->rays};
}

/// Gathers what a picture's pixels are computed from, except `lit`.
/// @param pixels  CV_8UC1: not 0 for the pixels to light
UnlitLens gather(const PictureCrew& crew, const ColourScene& scene,
                 const std::shared_ptr<const LensSight>& sight, bool smooth,
                 const cv::Mat& pixels) {
  UnlitLens picture{sight, {}, {}, {}, {}, {}, {}, {}, {}, {scene.view, scene.X_WL, scene.drawn}};
  picture.elsewhere =
      cv::Mat(pixels.size(), CV_8UC3, crew.light_painter.backgroundPixel(scene.exposure));
  picture.pixels = pixels;
  picture.regions = bandsOf(pixels);
  if (picture.regions.empty()) return picture;
  picture.smooth = smooth;
  picture.planes = crew.geometry_painter.planes();
  picture.is_classic = crew.draw_list.isClassic();
  // Edges take their light from the pixels around them.
  picture.wanted = smooth ? withPixelsAround(pixels) : pixels;
  picture.wanted_regions = bandsOf(picture.wanted);
  const bool is_full = scene.detail == LightDetail::kFull;
  picture.known = is_full ? withPixelsAround(picture.wanted, kOcclusionSmoothing) : picture.wanted;
  picture.place = boundsOf(is_full ? bandsOf(picture.known) : picture.wanted_regions);
  return picture;
}

/// The lights and the shadows that were drawn last, for pixels that are still to be chosen.
UnlitPixels lightsOf(const PictureCrew& crew, const ColourScene& scene) {
  return crew.light_painter.surfacesAlone(scene, {}, crew.shadow_painter, {}, {});
}

/// Adds a picture's pixels that are in some rows to those to light.
/// @param lights  of these rows
void addLit(UnlitPixels lights, const cv::Rect& rows, const ColourScene& scene,
            UnlitLens& picture) {
  if (picture.regions.empty()) return;
  lights.wanted = picture.wanted;
  for (const cv::Rect& region : picture.wanted_regions) {
    if (!(region & rows).empty()) lights.regions.push_back(region & rows);
  }
  if (lights.regions.empty()) return;
  const LensSight& sight = *picture.sight;
  const bool is_full = scene.detail == LightDetail::kFull;
  const cv::Rect place = picture.place & (is_full ? grown(rows, kOcclusionSmoothing) : rows);
  lights.seen = {{sight.items(place), sight.distance(place), {}}, {}, place, sight.lens->rays};
  if (is_full) lights.seen.occluders = occludersOf(sight, scene.view.camera);
  picture.lit.push_back(std::move(lights));
}

}  // namespace

/// The picture of what never moves; null until it is known to be needed again.
const LensPainter::Kept* LensPainter::kept(const ColourScene& scene, const LensSight& sight,
                                           const LinkSelection& casting, bool smooth) {
  constexpr std::size_t kMost = 8;
  if (!crew_.keeps) return nullptr;
  Key key{sight.lens,
          scene.view.X_WC.matrix(),
          crew_.draw_list.standing(scene.drawn),
          crew_.draw_list.standing(casting),
          {},
          scene.exposure,
          scene.detail,
          smooth};
  for (const ShadowProjection& shadow : scene.shadows) {
    key.shadows.push_back(shadow.shadow_from_world);
  }
  const auto known =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& each) { return each.key == key; });
  if (known == kept_.end()) {
    if (kept_.size() == kMost) kept_.pop_back();
    kept_.insert(kept_.begin(), {std::move(key), {}, {}, {}});
    return nullptr;
  }
  std::rotate(kept_.begin(), known, known + 1);
  Kept& here = kept_.front();
  if (!here.pixels.empty()) return &here;
  crew_.shadow_painter.paintStanding(scene.shadows, scene.X_WL, casting);
  const LinkSelection drawn = crew_.draw_list.standing(scene.drawn);
  const ColourScene alone{scene.view,     scene.X_WL, drawn,       scene.shadows,
                          scene.exposure, nullptr,    scene.detail};
  const auto seen = eye_.look(scene.view, scene.X_WL, drawn, Glass::kSeenThrough);
  const cv::Size size = seen->items.size();
  UnlitLens picture = gather(crew_, alone, seen, smooth, allPixels(size));
  addLit(lightsOf(crew_, alone), {cv::Point(), size}, alone, picture);
  const SurfaceImages surfaces = surfacesOf(picture);
  here.pixels = finishedThroughLens(picture, surfaces, crew_.draw_list, &here.edges);
  constexpr std::size_t kPixelBytes = 44;  // of surfaces and LensSight
  const auto known_surfaces = std::count_if(
      kept_.begin(), kept_.end(), [](const Kept& each) { return each.surfaces.sight != nullptr; });
  if (static_cast<std::size_t>(known_surfaces) < RecentViews::maxKept(kPixelBytes * size.area())) {
    here.surfaces = {seen, surfaces};
  }
  return &here;
}

/// CV_8UC1: 255 where something that moves may be seen in pixels, even outside their centres.
/// @param X_WL_too  the poses at another time; links move between the scene's poses and these
cv::Mat LensPainter::possibleSurfaces(const ColourScene& scene,
                                      const std::vector<Pose>& X_WL_too) const {
  const cv::Rect image(0, 0, scene.view.camera.width(), scene.view.camera.height());
  cv::Mat pixels = cv::Mat::zeros(image.size(), CV_8UC1);
  const Pose X_CW = scene.view.X_WC.inverse();
  const auto is_chosen = [&](const DrawItem& item) {
    return scene.drawn[item.link] && !item.stands_still;
  };
  std::vector<std::vector<Eigen::Vector3d>> hulls =
      hullsOfGroups(crew_.draw_list.items(), scene.X_WL, 0.0, is_chosen);
  const auto later = hullsOfGroups(crew_.draw_list.items(), X_WL_too, 0.0, is_chosen);
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    std::vector<Eigen::Vector3d>& hull = hulls[i];
    hull.insert(hull.end(), later[i].begin(), later[i].end());
    for (Eigen::Vector3d& point : hull) point = X_CW * point;
    const auto box = scene.view.camera.projectedBounds(hull);
    if (!box) continue;
    const auto cell = [](double place, int size) {
      return static_cast<int>(std::clamp(place, -1.0, static_cast<double>(size)));
    };
    const cv::Point first(cell(std::floor(box->left), image.width) - 1,
                          cell(std::floor(box->top), image.height) - 1);
    const cv::Point last(cell(std::ceil(box->right), image.width) + 1,
                         cell(std::ceil(box->bottom), image.height) + 1);
    pixels(cv::Rect(first, last + cv::Point(1, 1)) & image).setTo(255);
  }
  return pixels;
}

namespace {

/// The possible changes if there is no glass, but shadows may be anywhere.
PossibleChanges changesOf(const cv::Size& size) {
  return {cv::Mat::zeros(size, CV_8UC1), cv::Mat::zeros(size, CV_8UC1), allPixels(size)};
}

SeenGeometry seenBy(const LensSight& sight, const ColourScene& scene) {
  SeenGeometry seen{
      {sight.items, sight.distance, {}}, {cv::Point(), sight.items.size()}, sight.lens->rays};
  if (scene.detail == LightDetail::kFull) {
    seen.reaches = occlusionReaches(occludersOf(sight, scene.view.camera));
  }
  return seen;
}

}  // namespace

PendingPicture LensPainter::paint(const ColourScene& scene, const LinkSelection& casting,
                                  bool smooth, const std::vector<cv::Rect>& regions) {
  smooth = smooth && crew_.smooths;
  const auto sight = eye_.look(scene.view, scene.X_WL, scene.drawn, Glass::kSeenThrough);
  const cv::Size size = sight->items.size();
  cv::Mat wanted = allPixels(size);
  if (!regions.empty()) {
    wanted.setTo(0);
    for (const cv::Rect& region : regions) wanted(region & cv::Rect({}, size)).setTo(255);
  }
  const Kept* before = kept(scene, *sight, casting, smooth);
  crew_.shadow_painter.paint(scene.shadows, scene.X_WL, casting, {}, scene.casters);
  cv::Mat pixels;
  if (before == nullptr) {
    pixels = wanted;
  } else {
    PossibleChanges possible = changesOf(size);
    if (!before->edges.empty()) possible.surfaces = possibleSurfaces(scene, scene.X_WL);
    pixels = wanted & ChangedPixels(crew_.draw_list, scene.view)
                          .find(possible, seenBy(*sight, scene),
                                crew_.shadow_painter.changedTexels(scene.shadows), before->edges);
  }
  UnlitLens picture = gather(crew_, scene, sight, smooth, pixels);
  addLit(lightsOf(crew_, scene), {cv::Point(), size}, scene, picture);
  if (before != nullptr) {
    picture.standing = before->surfaces;
    if (regions.empty()) {
      picture.elsewhere = before->pixels;
    } else {
      before->pixels.copyTo(picture.elsewhere, wanted);
    }
  }
  return pending(std::move(picture), crew_.draw_list);
}

/// Rows whose lights and shadows are of the same time.
struct LensPainter::Band {
  cv::Rect rows;
  RollingMoment begin, middle, end;
  View view;
  CasterPoses casters;
  std::vector<LinkSelection> moving;  ///< as for ShadowPainter::paint()

  [[nodiscard]] ColourScene scene(const ColourScene& whole) const {
    ColourScene here{view, middle.X_WL, whole.drawn, whole.shadows, whole.exposure};
    here.detail = whole.detail;
    return here;
  }
};

std::vector<LensPainter::Band> LensPainter::bandsOfRows(const ColourScene& scene,
                                                        const RollingView& rows,
                                                        const LinkSelection& casting) const {
  std::vector<Band> bands;
  for (int i = 0; i < rows.bands; ++i) {
    const cv::Rect here = rows.rowsOf(i);
    const double first = here.y;
    const double last = first + here.height - 1;
    RollingMoment middle = rows.at(0.5 * (first + last));
    const View view{rows.camera, middle.X_WC};
    bands.push_back({here, rows.at(first), std::move(middle), rows.at(last), view, {}, {}});
    Band& band = bands.back();
    if (hasDistortion(rows.camera)) continue;
    band.moving =
        castersOnto(grown(band.rows, 2) & cv::Rect(0, 0, rows.camera.width(), rows.camera.height()),
                    crew_.draw_list.items(), band.view, band.middle.X_WL, scene.drawn, casting,
                    crew_.lights, scene.shadows);
  }
  std::vector<const std::vector<Pose>*> poses;
  for (const Band& band : bands) poses.push_back(&band.middle.X_WL);
  constexpr double kHeld = 1.0;  // [texel]
  std::vector<CasterPoses> held =
      heldForShadows(crew_.draw_list.items(), poses, scene.shadows, kHeld);
  for (std::size_t i = 0; i < bands.size(); ++i) bands[i].casters = std::move(held[i]);
  return bands;
}

PendingPicture LensPainter::paintInRows(const ColourScene& scene, const RollingView& rows,
                                        const LinkSelection& casting, bool smooth) {
  smooth = smooth && crew_.smooths;
  const auto sight = eye_.look(rows, scene.drawn, Glass::kSeenThrough);
  const cv::Size size = sight->items.size();
  const Kept* before = sight->rows->cameraStands() ? kept(scene, *sight, casting, smooth) : nullptr;
  const std::vector<Band> bands = bandsOfRows(scene, rows, casting);
  std::vector<UnlitPixels> lights;
  PossibleChanges possible = changesOf(size);
  cv::Mat pixels;
  if (before != nullptr) {
    // Pixels near something that moves may be in another band.
    pixels =
        ChangedPixels(crew_.draw_list, scene.view).find(possible, seenBy(*sight, scene), {}, {});
  }
  for (const Band& band : bands) {
    const ColourScene here = band.scene(scene);
    crew_.shadow_painter.paint(here.shadows, here.X_WL, casting, band.moving, &band.casters);
    lights.push_back(lightsOf(crew_, here));
    if (before == nullptr) continue;
    const SeenGeometry seen{
        {sight->items(band.rows), sight->distance(band.rows), {}}, band.rows, sight->lens->rays};
    pixels |= ChangedPixels(crew_.draw_list, here.view)
                  .find(possible, seen, crew_.shadow_painter.changedTexels(here.shadows), {});
    if (before->edges.empty()) continue;
    ColourScene begin{here.view, band.begin.X_WL, here.drawn, here.shadows};
    cv::Mat surfaces = possible.surfaces(band.rows);
    possibleSurfaces(begin, band.end.X_WL)(band.rows).copyTo(surfaces);
  }
  pixels = before == nullptr ? allPixels(size)
                             : ChangedPixels::withEdges(pixels, possible, before->edges);
  UnlitLens picture = gather(crew_, scene, sight, smooth, pixels);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    addLit(std::move(lights[i]), bands[i].rows, scene, picture);
  }
  if (before != nullptr) {
    picture.elsewhere = before->pixels;
    picture.standing = before->surfaces;
  }
  return pending(std::move(picture), crew_.draw_list);
}

}  // namespace synthetic_dataset::render
