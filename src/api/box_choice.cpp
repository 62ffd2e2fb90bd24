#include "synthetic_dataset/box_choice.h"

#include <string>

namespace synthetic_dataset {
inline namespace v2 {

BoxChoice readBoxChoice(Parameters& parameters) {
  const std::string box =
      parameters.optionalChoice("box", {"visible", "silhouette", "loose"}, "visible");
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
  const std::optional<Box> box = choice == BoxChoice::kLoose        ? object.loose_box
                                 : choice == BoxChoice::kSilhouette ? object.silhouette_box()
                                                                    : object.visibleBox();
  return box ? intersection(*box, camera.imageBounds()) : std::nullopt;
}

}  // namespace v2
}  // namespace synthetic_dataset
