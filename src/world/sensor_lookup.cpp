#include "world/sensor_lookup.h"

namespace synthetic_dataset::world {

std::string lastOf(const std::string& name) {
  const std::size_t scope = name.rfind("::");
  return scope == std::string::npos ? name : name.substr(scope + 2);
}

void requireFixedVariant(const std::string& name, const std::string& kind,
                         const LinkInstance& carrier, const std::vector<LinkInstance>& links) {
  const bool varies = std::any_of(links.begin(), links.end(), [&](const LinkInstance& link) {
    return link.object == carrier.object && link.variant > 0;
  });
  if (!varies || carrier.role != Role::kObject) return;
  throw Error(
      "found '" + name + "', a " + kind + " on '" + carrier.model +
      "', whose model, size or variant is drawn in randomize/objects; it should be on something "
      "that is always the same, or be put there by mounted_on");
}

}  // namespace synthetic_dataset::world
