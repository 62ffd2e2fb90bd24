#include "label/row_labels.h"

#include <algorithm>
#include <cmath>

namespace synthetic_dataset::label {
namespace {

/// The view with the objects' poses in place of the links'. An object that is absent at a moment
/// has the identity pose there.
render::RollingView viewOfObjects(const CapturedRows& taken) {
  render::RollingView view{taken.view.camera, {}, taken.view.bands};
  for (std::size_t i = 0; i < taken.view.moments.size(); ++i) {
    const render::RollingMoment& moment = taken.view.moments[i];
    view.moments.push_back({moment.row, moment.X_WC, {}});
    for (const std::optional<Pose>& X_GO : taken.X_GO[i]) {
      view.moments.back().X_WL.push_back(X_GO ? *X_GO : Pose::Identity());
    }
  }
  return view;
}

/// Labels an object where it appears in the picture.
/// @return its keypoints in the optical frame
std::vector<Eigen::Vector3d> placedObject(const RowFinder& rows, std::size_t index,
                                          SceneObject& object, const CameraModel& camera) {
  std::vector<Eigen::Vector3d> keypoints_C;
  for (std::size_t i = 0; i < object.keypoints.size(); ++i) {
    const auto found = rows.find(index, object.keypoints_O[i]);
    object.keypoints[i].pixel = found ? std::optional(found->pixel) : std::nullopt;
    keypoints_C.push_back(found ? found->p_C : *object.X_CO * object.keypoints_O[i]);
  }
  std::vector<Eigen::Vector3d> shape_C;
  for (const Eigen::Vector3d& p_O : object.bounding_shape_O) {
    const auto found = rows.find(index, p_O);
    shape_C.push_back(found ? found->p_C : *object.X_CO * p_O);
  }
  object.loose_box = camera.projectedBounds(shape_C);
  return keypoints_C;
}

}  // namespace

RowFinder::RowFinder(const render::RollingView& view, const std::vector<bool>& bodies)
    : view_(view), X_CB_(bodies.size()) {
  for (const render::RollingMoment& moment : view.moments) {
    const Pose X_CW = moment.X_WC.inverse();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i]) X_CB_[i].emplace_back(X_CW * moment.X_WL[i]);
    }
  }
}

std::optional<PointInRows> RowFinder::find(std::size_t body, const Eigen::Vector3d& p_B) const {
  const std::vector<render::RollingMoment>& moments = view_.moments;
  const double middle = 0.5 * (moments.front().row + moments.back().row);
  std::optional<PointInRows> nearest;
  const auto take = [&](const std::optional<PointInRows>& found) {
    const auto distance = [&](const PointInRows& at) { return std::abs(at.pixel.y() - middle); };
    if (found && (!nearest || distance(*found) < distance(*nearest))) nearest = found;
  };
  std::optional<double> before;  // by how many rows the point is below the row being taken
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const Eigen::Vector3d p_C = X_CB_[body][i] * p_B;
    const auto pixel = view_.camera.project(p_C);
    const auto below = pixel ? std::optional(pixel->y() - moments[i].row) : std::nullopt;
    if (below && i == 0 && *below < 0.0) take(PointInRows{*pixel, p_C});
    if (below && i + 1 == moments.size() && *below > 0.0) take(PointInRows{*pixel, p_C});
    if (below && before && (*before < 0.0) != (*below < 0.0)) {
      take(between(body, p_B, i, *before, *below));
    }
    before = below;
  }
  return nearest;
}

/// @param moment  the first one after the time that is looked for
/// @param before, after  how far the point is below the row being taken, at the previous moment and
///     at this one; of opposite signs
std::optional<PointInRows> RowFinder::between(std::size_t body, const Eigen::Vector3d& p_B,
                                              std::size_t moment, double before,
                                              double after) const {
  constexpr double kEnough = 1e-7;  // [px]
  constexpr int kMostSteps = 100;
  double first = view_.moments[moment - 1].row;
  double last = view_.moments[moment].row;
  std::optional<PointInRows> found;
  // Regula falsi; an end that stays is given half its weight (the Illinois method).
  for (int step = 0; step < kMostSteps; ++step) {
    const double row = last - after * (last - first) / (after - before);
    const Eigen::Vector3d p_C = view_.X_CL(body, row) * p_B;
    const auto pixel = view_.camera.project(p_C);
    if (!pixel) return std::nullopt;
    found = PointInRows{*pixel, p_C};
    const double below = pixel->y() - row;
    if (std::abs(below) < kEnough) break;
    if ((below < 0.0) == (after < 0.0)) {
      before *= 0.5;
    } else {
      first = last;
      before = after;
    }
    last = row;
    after = below;
  }
  return found;
}

std::vector<std::vector<Eigen::Vector3d>> labelInRows(const CapturedRows& taken, Scene& scene) {
  const render::RollingView view = viewOfObjects(taken);
  std::vector<bool> present;
  for (const SceneObject& object : scene.objects) present.push_back(object.X_CO.has_value());
  const RowFinder rows(view, present);
  std::vector<std::vector<Eigen::Vector3d>> placed;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    placed.emplace_back();
    if (present[i]) placed.back() = placedObject(rows, i, scene.objects[i], scene.camera);
  }
  return placed;
}

}  // namespace synthetic_dataset::label
