#include "scene/field_of_view.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostics.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::scene {
namespace {

/// Close to pi, a planar image shows nearly everything in its very middle.
constexpr double kWidestPlane = 3.1;  // [rad]

/// The widest field of view that the camera can have [rad].
double widestOf(const CameraModel& camera) {
  return 2.0 * camera.angleAt(std::tan(0.5 * kWidestPlane));
}

}  // namespace

double fieldOfView(const CameraModel& camera) {
  return 2.0 * camera.angleAt(0.5 * (camera.width() / camera.intrinsics().fx));
}

bool canHaveFieldOfView(const CameraModel& camera, double field_of_view) {
  if (!(field_of_view > 0.0)) return false;
  const auto radius = camera.radiusAt(0.5 * field_of_view);
  return radius && *radius > 0.0 && *radius <= std::tan(0.5 * kWidestPlane);
}

CameraModel withFieldOfView(const CameraModel& camera, double field_of_view) {
  if (!canHaveFieldOfView(camera, field_of_view)) {
    throw Error("field of view: found " + fixed(field_of_view, 3) +
                " rad; it should be above 0 and at most " + fixed(widestOf(camera), 3));
  }
  const double fx = 0.5 * camera.width() / *camera.radiusAt(0.5 * field_of_view);
  Intrinsics intrinsics = camera.intrinsics();
  intrinsics.fy *= fx / intrinsics.fx;
  intrinsics.fx = fx;
  return {camera.width(), camera.height(), intrinsics,
          camera.near(),  camera.far(),    camera.distortion()};
}

void checkFieldOfView(const base::Distribution& field_of_view, const std::string& parameter,
                      const std::vector<CameraRig>& cameras) {
  base::Diagnostics errors;
  for (const CameraRig& camera : cameras) {
    if (canHaveFieldOfView(camera.model, field_of_view.highest())) continue;
    errors.error(
        parameter,
        "found up to " + fixed(field_of_view.highest(), 3) + " rad; it should be at most " +
            fixed(widestOf(camera.model), 3) + ", as '" + camera.name +
            "' is not a fisheye (calibrated as `equidistant`); a normal distribution ends at its "
            "`max`");
  }
  errors.throwIfAny();
}

void warnOfBlackEdges(const base::Distribution& field_of_view, const std::string& parameter,
                      const std::vector<CameraRig>& cameras, base::Diagnostics& diagnostics) {
  constexpr double kLittle = 0.5;
  for (const CameraRig& camera : cameras) {
    const double widest = std::min(field_of_view.highest(), widestOf(camera.model));
    const double share = seenShare(withFieldOfView(camera.model, widest));
    if (share >= kLittle || share >= 0.9 * seenShare(camera.model)) continue;
    diagnostics.warning(parameter, "at " + fixed(widest, 3) + " rad, the lens of '" + camera.name +
                                       "' sees something in only " + fixed(100.0 * share, 0) +
                                       " % of the image; the rest is black");
  }
}

}  // namespace synthetic_dataset::scene
