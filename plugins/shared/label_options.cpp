#include "plugins/shared/label_options.h"

#include <algorithm>

#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset {
namespace {

void checkChoice(const Parameters& parameters, const std::string& name,
                 const std::vector<std::string>& choices, const std::string& choice) {
  if (std::find(choices.begin(), choices.end(), choice) != choices.end()) return;
  std::string all = choices.front();
  for (std::size_t i = 1; i < choices.size(); ++i) {
    all += (i + 1 < choices.size() ? ", " : " or ") + choices[i];
  }
  parameters.addError(name,
                      "found '" + choice + "'; it should be " + all + didYouMean(choice, choices));
}

}  // namespace

std::string optionalChoice(const Parameters& parameters, const std::string& name,
                           const std::vector<std::string>& choices, const std::string& fallback) {
  std::string choice = parameters.optional(name, fallback);
  checkChoice(parameters, name, choices, choice);
  return choice;
}

std::string requiredChoice(const Parameters& parameters, const std::string& name,
                           const std::vector<std::string>& choices) {
  const std::size_t errors_before = parameters.errors().size();
  std::string choice = parameters.required<std::string>(name);
  if (parameters.errors().size() == errors_before) checkChoice(parameters, name, choices, choice);
  return choice;
}

BoxChoice readBoxChoice(const Parameters& parameters) {
  const std::string box =
      optionalChoice(parameters, "box", {"visible", "silhouette", "loose"}, "visible");
  if (box == "loose") return BoxChoice::kLoose;
  return box == "silhouette" ? BoxChoice::kSilhouette : BoxChoice::kVisible;
}

Requirements requirementsOf(BoxChoice choice) {
  Requirements requirements;
  requirements.visible_masks = true;
  requirements.visibility = choice == BoxChoice::kSilhouette;
  return requirements;
}

std::optional<Box> boxOf(const SceneObject& object, BoxChoice choice, const CameraModel& camera) {
  std::optional<Box> box = object.visible_box;
  if (choice == BoxChoice::kSilhouette) box = object.silhouette_box;
  if (choice == BoxChoice::kLoose) box = object.loose_box;
  return box ? intersection(*box, camera.imageBounds()) : std::nullopt;
}

cv::Rect visiblePixels(const SceneObject& object) {
  if (!object.visible_box) return {};
  const Box& box = *object.visible_box;
  return {cv::Point(cvRound(box.left + 0.5), cvRound(box.top + 0.5)),
          cv::Point(cvRound(box.right + 0.5), cvRound(box.bottom + 0.5))};
}

std::string splitOf(const Scene& scene) { return scene.split.empty() ? "train" : scene.split; }

std::string flatName(const Scene& scene) {
  const std::size_t slash = scene.name.rfind('/');
  if (slash == std::string::npos) return scene.name;
  return safeFileName(scene.name.substr(0, slash)) + "_" + scene.name.substr(slash + 1);
}

}  // namespace synthetic_dataset
