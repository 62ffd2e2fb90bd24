#include "plugins/readback/cloud_colours.h"

#include <algorithm>
#include <set>

#include "plugins/readback/label_overlay.h"

namespace synthetic_dataset::formats {

std::map<std::uint16_t, ClassColour> classColours(const LabelledCloud& cloud,
                                                  const std::vector<std::string>& object_classes) {
  constexpr double kDull = 0.55;  // share of grey in the colour
  std::set<std::string> of_objects(object_classes.begin(), object_classes.end());
  for (const auto& [number, object] : cloud.objects) of_objects.insert(object.class_name);
  std::map<std::uint16_t, ClassColour> colours;
  std::size_t next = object_classes.size();
  for (const auto& [number, name] : cloud.classes) {
    const auto found = std::find(object_classes.begin(), object_classes.end(), name);
    const bool is_listed = found != object_classes.end();
    const cv::Scalar colour =
        labelColour(is_listed ? static_cast<std::size_t>(found - object_classes.begin()) : next++);
    const bool is_of_world = of_objects.count(name) == 0;
    colours[number] = {is_of_world ? (1.0 - kDull) * colour + kDull * kUnlabelledColour : colour,
                       is_of_world};
  }
  return colours;
}

}  // namespace synthetic_dataset::formats
