#include "plugins/mot/mot_options.h"

#include <algorithm>

namespace synthetic_dataset {

MotOptions readMotOptions(Parameters& parameters, const std::vector<ClassInfo>& classes) {
  constexpr int kGreatest = 65535;
  MotOptions options;
  Parameters ids = parameters.group("class_ids");
  for (const ClassInfo& each : classes) {
    const int id = ids.optionalBetween(each.name, each.id + 1, 1, kGreatest);
    options.class_ids[each.id] = id;
    while (options.names.size() < static_cast<std::size_t>(id)) {
      options.names.push_back("unused_" + std::to_string(options.names.size() + 1));
    }
    std::string& name = options.names[static_cast<std::size_t>(id) - 1];
    if (name.rfind("unused_", 0) == 0) name = each.name;  // classes may share a number
  }
  options.box = readBoxChoice(parameters);
  options.image_format = parameters.optionalChoice("image_format", {"jpg", "png"}, "jpg");
  return options;
}

}  // namespace synthetic_dataset
