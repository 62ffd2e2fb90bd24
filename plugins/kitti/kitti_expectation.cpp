#include "plugins/kitti/kitti_expectation.h"

#include <cmath>
#include <utility>

namespace synthetic_dataset::formats {

ExpectedLabels expectedKittiLabels(const KittiOptions& options, const MeasuredScene& scene) {
  ExpectedLabels expected;
  for (const MeasuredObject& object : scene.objects) {
    const auto type = options.types.find(object.class_name);
    ExpectedLabel label{object.name, type == options.types.end() ? "" : type->second};
    label.box_tolerance = std::pow(10.0, -kKittiDecimals);
    if (object.labelled()) {
      label.box = scene.box(object, options.box);
    } else if (options.dont_care && object.isSeen()) {
      label.class_name = kDontCare;
      label.box = object.visible_box;
    }
    if (label.box) expected.labels.push_back(std::move(label));
  }
  return expected;
}

}  // namespace synthetic_dataset::formats
