#include "programs/drawing/sweep_facts.h"

#include <cstdint>
#include <string>

namespace synthetic_dataset::programs {

Value::Map sweepFacts(const formats::LabelledCloud& cloud) {
  Value::Map classes;
  for (const auto& [number, count] : formats::pointsOfClasses(cloud)) {
    const auto name = cloud.classes.find(number);
    const std::string other = number == 0 ? "" : "class " + std::to_string(number);
    classes[name != cloud.classes.end() ? name->second : other] = count;
  }
  Value::List objects;
  for (const auto& [number, count] : formats::pointsOfObjects(cloud)) {
    const formats::LabelledCloud::Object& object = cloud.objects.at(number);
    objects.emplace_back(
        Value::Map{{"name", object.caption}, {"class", object.class_name}, {"points", count}});
  }
  Value::Map facts{{"lidar", cloud.lidar},
                   {"points", static_cast<std::int64_t>(cloud.points.size())},
                   {"labelled", cloud.has_labels},
                   {"classes", classes},
                   {"objects", objects}};
  if (cloud.rays) facts["rays"] = *cloud.rays;
  return facts;
}

}  // namespace synthetic_dataset::programs
