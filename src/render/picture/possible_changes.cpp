#include "render/picture/possible_changes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <opencv2/core.hpp>

#include "render/parts/item_groups.h"
#include "render/pixels/hull_pixels.h"

namespace synthetic_dataset::render {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// If a shadow may reach more than this many times as far from a light as its caster, it is taken
/// to reach everywhere.
constexpr double kFarthest = 1000.0;

/// How far something may move along one axis inside the receivers' bounds: the largest `factor`
/// such that start + factor * step is in [least, most] for any start in [low, high], or infinity.
double longestWay(double low, double high, double step, double least, double most) {
  if (step > 0.0) return (most - low) / step;
  if (step < 0.0) return (least - high) / step;
  return std::numeric_limits<double>::infinity();
}

Bounds pointBounds(const Points& points) {
  Bounds bounds;
  for (const Eigen::Vector3d& point : points) bounds.extend(point);
  return bounds;
}

/// The hull of a body and its shadow in parallel light, as far as there are receivers.
Points parallelShadow(const Points& corners, const Eigen::Vector3d& direction,
                      const Bounds& receivers) {
  const Bounds caster = pointBounds(corners);
  double way = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    way = std::min(way, longestWay(caster.min()[axis], caster.max()[axis], direction[axis],
                                   receivers.min()[axis], receivers.max()[axis]));
  }
  Points hull = corners;
  for (const Eigen::Vector3d& corner : corners) {
    hull.push_back(corner + std::max(way, 0.0) * direction);
  }
  return hull;
}

/// The same in the light of a point; nothing if the shadow may be anywhere.
std::optional<Points> pointShadow(const Points& corners, const Eigen::Vector3d& light, double range,
                                  const Bounds& receivers) {
  const Bounds caster = pointBounds(corners);
  double times = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    // Rays from the light through the body continue along an axis by at most `times`.
    const double low = caster.min()[axis] - light[axis];
    const double high = caster.max()[axis] - light[axis];
    if (low > 0.0) times = std::min(times, (receivers.max()[axis] - light[axis]) / low);
    if (high < 0.0) times = std::min(times, (receivers.min()[axis] - light[axis]) / high);
  }
  const double nearest = caster.exteriorDistance(light);
  if (nearest > 0.0) times = std::min(times, range / nearest);  // it is dark beyond
  if (!(times < kFarthest)) return std::nullopt;
  Points hull = corners;
  for (const Eigen::Vector3d& corner : corners) {
    hull.push_back(light + std::max(times, 1.0) * (corner - light));
  }
  return hull;
}

/// The most by which a shadow is blurred and shifted [m], which depends on its map's texels.
double blurOf(const world::Light& light, const ShadowProjection& shadow) {
  constexpr double kTexels = 8.0;
  const double softness = std::min(shadow.softness.maxCoeff(), kWidestSoftness);
  const bool from_point = light.type != world::LightType::kDirectional;
  return (kTexels + softness) * shadow.texel * (from_point ? std::max(light.range, 1.0) : 1.0);
}

/// The hull of a caster and its shadow, as far as there are receivers; nothing if the shadow may be
/// anywhere.
/// @param caster  a hull of the caster, extended by its shadow's blur
std::optional<Points> shadowOf(const Points& caster, const world::Light& light,
                               const Bounds& receivers) {
  if (light.type != world::LightType::kDirectional) {
    return pointShadow(caster, light.X_WL.translation(), light.range, receivers);
  }
  const Eigen::Vector3d direction = (light.X_WL.linear() * light.direction_L).normalized();
  return parallelShadow(caster, direction, receivers);
}

/// Marks the pixels on which the shadow of a caster may be seen, with a small margin.
void markShadow(const Points& caster, const world::Light& light, const Bounds& receivers,
                const View& view, cv::Mat& pixels) {
  if (const std::optional<Points> hull = shadowOf(caster, light, receivers)) {
    markHull(*hull, view, pixels);
  } else {
    pixels.setTo(255);
  }
}

cv::Mat noPixels(const View& view) {
  return cv::Mat::zeros(view.camera.height(), view.camera.width(), CV_8UC1);
}

bool castsAndMoves(const DrawItem& item, const LinkSelection& casting) {
  return casting[item.link] && item.casts_shadow && !item.stands_still;
}

/// The bounds of each link that casts shadows and moves, by link; empty for all others.
std::vector<Bounds> movingCasters(const std::vector<DrawItem>& items, const std::vector<Pose>& X_WL,
                                  const LinkSelection& casting) {
  std::vector<Bounds> casters(X_WL.size());
  for (const DrawItem& item : items) {
    if (castsAndMoves(item, casting)) extend(casters[item.link], item, X_WL[item.link]);
  }
  return casters;
}

}  // namespace

std::vector<LinkSelection> castersOnto(const cv::Rect& pixels, const std::vector<DrawItem>& items,
                                       const View& view, const std::vector<Pose>& X_WL,
                                       const LinkSelection& drawn, const LinkSelection& casting,
                                       const std::vector<world::Light>& lights,
                                       const std::vector<ShadowProjection>& shadows) {
  Bounds receivers;
  for (const DrawItem& item : items) {
    if (drawn[item.link]) extend(receivers, item, X_WL[item.link]);
  }
  const std::vector<Bounds> casters = movingCasters(items, X_WL, casting);
  std::vector<LinkSelection> selected;
  int selected_of = -1;
  for (const ShadowProjection& shadow : shadows) {
    if (std::exchange(selected_of, shadow.light) == shadow.light) {  // another side of the cube
      selected.push_back(LinkSelection(selected.back()));
      continue;
    }
    const world::Light& light = lights[static_cast<std::size_t>(shadow.light)];
    const Eigen::Vector3d blur = Eigen::Vector3d::Constant(blurOf(light, shadow));
    LinkSelection& links = selected.emplace_back(casters.size(), false);
    for (std::size_t link = 0; link < casters.size(); ++link) {
      if (casters[link].isEmpty()) continue;
      const Bounds caster(casters[link].min() - blur, casters[link].max() + blur);
      const std::optional<Points> hull = shadowOf(cornersOf(caster), light, receivers);
      links[link] = !hull || !(pixelsOfHull(*hull, view) & pixels).empty();
    }
  }
  return selected;
}

PossibleChanges possibleChanges(const std::vector<DrawItem>& items, const View& view,
                                const std::vector<Pose>& X_WL, const LinkSelection& drawn,
                                const LinkSelection& casting,
                                const std::vector<world::Light>& lights,
                                const std::vector<ShadowProjection>& shadows) {
  const auto markSeen = [&](const std::function<bool(const DrawItem&)>& is_chosen) {
    cv::Mat pixels = noPixels(view);
    for (const Points& hull : hullsOfGroups(items, X_WL, 0.0, is_chosen)) {
      markHull(hull, view, pixels);
    }
    return pixels;
  };
  PossibleChanges regions;
  regions.surfaces = markSeen([&](const DrawItem& item) {
    return drawn[item.link] && !item.stands_still && !item.transparent;
  });
  regions.glass =
      markSeen([&](const DrawItem& item) { return drawn[item.link] && item.transparent; });
  regions.shadows = noPixels(view);
  Bounds receivers;
  for (const DrawItem& item : items) {
    if (drawn[item.link] && item.stands_still) extend(receivers, item, X_WL[item.link]);
  }
  if (receivers.isEmpty()) return regions;
  const auto moves = [&](const DrawItem& item) { return castsAndMoves(item, casting); };
  int marked = -1;
  for (const ShadowProjection& shadow : shadows) {
    if (std::exchange(marked, shadow.light) == shadow.light) continue;  // another side of the cube
    const world::Light& light = lights[static_cast<std::size_t>(shadow.light)];
    for (const Points& caster : hullsOfGroups(items, X_WL, blurOf(light, shadow), moves)) {
      markShadow(caster, light, receivers, view, regions.shadows);
    }
  }
  return regions;
}

}  // namespace synthetic_dataset::render
