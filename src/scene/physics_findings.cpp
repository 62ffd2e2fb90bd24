#include "scene/physics_findings.h"

#include "base/seconds.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::scene {

std::vector<base::ContactFacts> PhysicsFindings::contacts(
    Stamp stamp, std::vector<base::Warning>& warnings) const {
  std::vector<base::ContactFacts> contacts;
  const std::string metres = fixed(tolerance_, 3);
  for (const world::Interpenetration& pair : world_.interpenetrations()) {
    contacts.push_back({pair.first, pair.second, pair.depth});
    warnings.push_back({"'" + pair.first + "' and '" + pair.second + "' are inside one another",
                        "by " + fixed(pair.depth, 3) + " m at " + fixed(toSeconds(stamp), 3) +
                            " s; physics/contact_tolerance allows " + metres + " m"});
  }
  return contacts;
}

void PhysicsFindings::addFallen(Stamp stamp, std::vector<base::Warning>& warnings) const {
  for (const std::string& name : world_.fallenProps()) {
    warnings.push_back(
        {"model '" + name + "' has fallen out of the world: it is not static, and nothing holds it",
         "at " + fixed(toSeconds(stamp), 3) + " s"});
  }
}

}  // namespace synthetic_dataset::scene
