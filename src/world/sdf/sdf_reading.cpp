#include "world/sdf/sdf_reading.h"

#include <sstream>

#include "world/sdf/sdf_document.h"

namespace synthetic_dataset::world {

std::filesystem::path SdfReading::folderOf(const sdf::ElementPtr& element) const {
  const std::string from = fileOf(element);
  return (from.empty() ? file : std::filesystem::path(from)).parent_path();
}

Pose resolve(const sdf::SemanticPose& pose, const Place& place, SdfReading& reading) {
  auto resolved = pose.RawPose();
  const sdf::Errors errors = pose.Resolve(resolved);
  if (!errors.empty() && reading.sound) {
    reading.findings.addError(place.message("its pose is unknown: " + errors.front().Message()));
  }
  const Pose result = toPose(errors.empty() ? resolved : pose.RawPose());
  constexpr double kFarthest = 1e7;  // [m]: there is no telling points beyond it apart
  if (result.matrix().allFinite() && result.translation().cwiseAbs().maxCoeff() <= kFarthest) {
    return result;
  }
  reading.findings.addError(
      place.message("its pose has a number that is not finite, or lies more than 1e7 m away"));
  return Pose::Identity();
}

bool has(const sdf::ElementPtr& parent, const char* name) {
  return parent && parent->HasElement(name) && isInFile(parent->GetElement(name));
}

sdf::ElementPtr descendant(const sdf::ElementPtr& parent, std::initializer_list<const char*> path) {
  sdf::ElementPtr element = parent;
  for (const char* name : path) {
    if (!has(element, name)) return nullptr;
    element = element->GetElement(name);
  }
  return element;
}

std::vector<double> numbers(const sdf::ElementPtr& element) {
  const sdf::ParamPtr value = element->GetValue();
  std::istringstream text(value ? value->GetAsString() : "");
  std::vector<double> result;
  for (double each = 0.0; text >> each;) result.push_back(each);
  return result;
}

double number(const sdf::ElementPtr& parent, std::initializer_list<const char*> path,
              double fallback) {
  const sdf::ElementPtr element = descendant(parent, path);
  return element ? element->Get<double>() : fallback;
}

}  // namespace synthetic_dataset::world
