#include "render/picture/lens_painter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/core.hpp>

#include "render/edges/edge_pixels.h"
#include "render/lens/lens_edges.h"
#include "render/lens/lens_surfaces.h"
#include "render/parts/part_groups.h"
#include "render/picture/changed_pixels.h"
#include "render/pixels/pixel_bands.h"
#include "render/pixels/srgb.h"
#include "synthetic_dataset/mask.h"

namespace synthetic_dataset::render {
namespace {

cv::Mat allPixels(const cv::Size& size) { return {size, CV_8UC1, cv::Scalar(255)}; }

/// A picture through a lens whose light is still to be found.
struct UnlitLens {
  std::shared_ptr<const LensSight> sight;
  cv::Mat elsewhere;              ///< CV_8UC3: what is not in `pixels`
  cv::Mat pixels;                 ///< CV_8UC1: 255 for the other pixels
  std::vector<cv::Rect> regions;  ///< around these
  UnlitPixels unlit;              ///< them, and those by them where edges are smooth
  cv::Mat known;                  ///< CV_8UC1: not 0 for those whose surfaces these need
  EdgeScene scene;
  GeometryPlanes planes;
  bool is_classic = false;
  bool smooth = false;
};

/// @param edges  gets the pixels of smoothed edges, if not null
cv::Mat finishedThroughLens(const UnlitLens& picture, const DrawList& parts, cv::Mat* edges) {
  cv::Mat result = picture.elsewhere.clone();
  if (picture.regions.empty()) return result;
  UnlitPixels unlit = picture.unlit;
  SeenSurfaces& seen = unlit.seen;
  seen.surfaces =
      surfacesOf(*picture.sight, picture.planes, picture.is_classic, seen.place, picture.known);
  seen.geometry.normals = seen.surfaces.vertexNormals();
  const cv::Mat light = unlit.light();
  for (const cv::Rect& region : picture.regions) {
    cv::Mat pixels = result(region);
    encodeSrgb(light(region - seen.place.tl()), picture.pixels(region), pixels);
  }
  if (picture.smooth) {
    const EdgePixels found(seen.geometry, seen.place, picture.regions, picture.pixels,
                           unlit.intrinsics, seen.rays);
    smoothEdges(parts, picture.scene, *picture.sight, {seen.geometry, light, seen.place}, found,
                result);
    if (edges != nullptr) *edges = found.mask(result.size());
  }
  result.setTo(cv::Scalar::all(0), picture.sight->lens->face < 0);
  return result;
}

}  // namespace

bool LensPainter::Key::operator==(const Key& other) const {
  return lens == other.lens && X_WC == other.X_WC && drawn == other.drawn &&
         casting == other.casting && shadows == other.shadows && exposure == other.exposure &&
         detail == other.detail && smooth == other.smooth;
}

LinkSelection LensPainter::standing(const LinkSelection& links) const {
  LinkSelection selected(links.size(), false);
  for (const Part& part : crew_.parts.parts()) {
    if (part.stands_still) selected[part.link] = links[part.link];
  }
  return selected;
}

namespace {

Occluders occludersOf(const LensSight& sight, const CameraModel& camera) {
  const cv::Size size = sight.parts.size();
  return {sight.distance, {cv::Point(), size}, size, camera.intrinsics(), sight.lens->rays};
}

/// Gathers what a picture's pixels are found from.
/// @param pixels  those that are not 0
UnlitLens gather(const PictureCrew& crew, const ColourScene& scene,
                 const std::shared_ptr<const LensSight>& sight, bool smooth,
                 const cv::Mat& pixels) {
  UnlitLens picture{sight, {}, {}, {}, {}, {}, {scene.view, scene.X_WL, scene.drawn}, {}};
  picture.elsewhere =
      cv::Mat(pixels.size(), CV_8UC3, crew.light_painter.backgroundPixel(scene.exposure));
  picture.pixels = pixels;
  picture.regions = bandsOf(pixels);
  if (picture.regions.empty()) return picture;
  picture.smooth = smooth;
  picture.planes = crew.geometry_painter.planes();
  picture.is_classic = crew.parts.isClassic();
  // Edges take their light from the pixels around them.
  const cv::Mat wanted = smooth ? withPixelsAround(pixels) : pixels;
  const std::vector<cv::Rect> lit = smooth ? bandsOf(wanted) : picture.regions;
  const bool is_full = scene.detail == LightDetail::kFull;
  picture.known = is_full ? withPixelsAround(wanted, kOcclusionSmoothing) : wanted;
  const cv::Rect place = is_full ? boundsOf(bandsOf(picture.known)) : boundsOf(lit);
  SeenSurfaces seen{
      {sight->parts(place), sight->distance(place), {}}, {}, place, sight->lens->rays};
  if (is_full) seen.occluders = occludersOf(*sight, scene.view.camera);
  picture.unlit = crew.light_painter.surfacesAlone(scene, seen, crew.shadow_painter, lit, wanted);
  return picture;
}

}  // namespace

/// That of what never moves, or null while it is not known whether it will be needed again.
const LensPainter::Kept* LensPainter::kept(const ColourScene& scene, const LensSight& sight,
                                           const LinkSelection& casting, bool smooth) {
  constexpr std::size_t kMost = 8;
  if (!crew_.keeps) return nullptr;
  Key key{sight.lens, scene.view.X_WC.matrix(), standing(scene.drawn), standing(casting),
          {},         scene.exposure,           scene.detail,          smooth};
  for (const ShadowProjection& shadow : scene.shadows) {
    key.shadows.push_back(shadow.shadow_from_world);
  }
  const auto known =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& each) { return each.key == key; });
  if (known == kept_.end()) {
    if (kept_.size() == kMost) kept_.pop_back();
    kept_.insert(kept_.begin(), {std::move(key), {}, {}});
    return nullptr;
  }
  std::rotate(kept_.begin(), known, known + 1);
  Kept& here = kept_.front();
  if (!here.pixels.empty()) return &here;
  crew_.shadow_painter.paintStanding(scene.shadows, scene.X_WL, casting);
  const LinkSelection drawn = standing(scene.drawn);
  const ColourScene alone{scene.view,     scene.X_WL, drawn,       scene.shadows,
                          scene.exposure, nullptr,    scene.detail};
  const auto seen = eye_.look(scene.view, scene.X_WL, drawn, Glass::kSeenThrough);
  here.pixels = finishedThroughLens(
      gather(crew_, alone, seen, smooth, allPixels(seen->parts.size())), crew_.parts, &here.edges);
  return &here;
}

/// CV_8UC1: 255 where something that moves may be seen beside pixels' centres.
cv::Mat LensPainter::possibleSurfaces(const ColourScene& scene) const {
  const cv::Rect image(0, 0, scene.view.camera.width(), scene.view.camera.height());
  cv::Mat pixels = cv::Mat::zeros(image.size(), CV_8UC1);
  const Pose X_CW = scene.view.X_WC.inverse();
  const auto is_chosen = [&](const Part& part) {
    return scene.drawn[part.link] && !part.stands_still;
  };
  for (std::vector<Eigen::Vector3d>& hull :
       hullsOfGroups(crew_.parts.parts(), scene.X_WL, 0.0, is_chosen)) {
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

/// Which pixels differ from those of the kept picture.
/// @param edges  of the kept picture
cv::Mat LensPainter::changedPixels(const ColourScene& scene, const LensSight& sight,
                                   const cv::Mat& edges) const {
  std::vector<ChangedTexels> texels;
  for (const ShadowProjection& shadow : scene.shadows) {
    texels.push_back(crew_.shadow_painter.changedTexels(shadow));
  }
  const cv::Size size = sight.parts.size();
  PossibleChanges regions;
  regions.glass = cv::Mat::zeros(size, CV_8UC1);
  regions.shadows = allPixels(size);
  regions.surfaces = edges.empty() ? regions.glass : possibleSurfaces(scene);
  SeenGeometry seen{{sight.parts, sight.distance, {}}, {cv::Point(), size}, sight.lens->rays};
  if (scene.detail == LightDetail::kFull) {
    seen.reaches = occlusionReaches(occludersOf(sight, scene.view.camera));
  }
  return ChangedPixels(crew_.parts, scene.view).find(regions, seen, texels, edges);
}

PendingPicture LensPainter::paint(const ColourScene& scene, const LinkSelection& casting,
                                  bool smooth, const std::vector<cv::Rect>& regions) {
  smooth = smooth && crew_.smooths;
  const auto sight = eye_.look(scene.view, scene.X_WL, scene.drawn, Glass::kSeenThrough);
  const cv::Size size = sight->parts.size();
  cv::Mat wanted = allPixels(size);
  if (!regions.empty()) {
    wanted.setTo(0);
    for (const cv::Rect& region : regions) wanted(region & cv::Rect({}, size)).setTo(255);
  }
  const Kept* before = kept(scene, *sight, casting, smooth);
  crew_.shadow_painter.paint(scene.shadows, scene.X_WL, casting);
  // Not by assigning to a copy of `wanted`: OpenCV would write into the pixels that both share.
  const cv::Mat pixels =
      before == nullptr ? wanted : cv::Mat(wanted & changedPixels(scene, *sight, before->edges));
  UnlitLens picture = gather(crew_, scene, sight, smooth, pixels);
  if (before != nullptr) {
    if (regions.empty()) {
      picture.elsewhere = before->pixels;
    } else {
      before->pixels.copyTo(picture.elsewhere, wanted);
    }
  }
  return [this, picture = std::move(picture)] {
    return finishedThroughLens(picture, crew_.parts, nullptr);
  };
}

}  // namespace synthetic_dataset::render
