#include "run/setup/size_checks.h"

#include <algorithm>
#include <string>

#include "scene/object_shapes.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

/// Nobody means to be so many times off.
constexpr double kStrange = 4.0;

double diagonal(const Cuboid& box) { return box.size().norm(); }

/// How far a point is from a box [m].
double distanceTo(const Cuboid& box, const Eigen::Vector3d& point) {
  return (point - point.cwiseMax(box.low).cwiseMin(box.high)).norm();
}

std::string metres(double length) { return fixed(length, 3) + " m"; }

}  // namespace

void checkSizes(const scene::ObjectOptions& object, const Cuboid& box_O,
                base::Diagnostics& diagnostics) {
  const double model = diagonal(box_O);
  if (!object.bounding_shape_O.empty()) {
    const Cuboid given = scene::boxAround(object.bounding_shape_O);
    const double reach = diagonal(given);
    if (reach > kStrange * model || model > kStrange * reach) {
      diagnostics.warning(object.name + "/bounding_shape",
                          "its points reach over " + metres(reach) + ", the model over " +
                              metres(model) + " (are they in metres?)");
    } else if (distanceTo(box_O, given.centre()) > model) {
      diagnostics.warning(object.name + "/bounding_shape",
                          "its middle is " + metres(distanceTo(box_O, given.centre())) +
                              " away from the model (are its points in the frame of the object?)");
    }
  }
  double farthest = 0.0;
  for (const Eigen::Vector3d& point : object.keypoints_O) {
    farthest = std::max(farthest, distanceTo(box_O, point));
  }
  constexpr double kOutside = 0.25;  // of the model's size; an antenna's tip may be left out of it
  if (farthest > kOutside * model) {
    diagnostics.warning(object.name + "/keypoints",
                        "one is " + metres(farthest) + " away from the model, which reaches over " +
                            metres(model) +
                            " (are they in metres, and in the frame of the object?)");
  }
}

}  // namespace synthetic_dataset::run
