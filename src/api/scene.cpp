#include "synthetic_dataset/scene.h"

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
inline namespace v2 {

std::optional<Box> SceneObject::visibleBox() const {
  const cv::Rect bounds = visible_mask().bounds();
  if (bounds.empty()) return std::nullopt;
  return boxAround(bounds);
}

double SceneObject::visibility() const {
  const auto of_all = static_cast<double>(pixels.silhouette());
  return of_all > 0.0 ? static_cast<double>(pixels.visible()) / of_all : 0.0;
}

double SceneObject::truncation() const {
  const auto of_all = static_cast<double>(pixels.silhouette());
  return of_all > 0.0 ? 1.0 - static_cast<double>(pixels.silhouette_in_image()) / of_all : 0.0;
}

double SceneObject::distance() const {
  if (!X_CO) throw Error("'" + name + "' is not in the scene, and so at no distance");
  return X_CO->translation().norm();
}

Pose Scene::transform(const std::string& target, const std::string& source) const {
  if (!transforms_) throw Error("the scene knows no frames, '" + source + "' neither");
  return transforms_(target, source);
}

std::string Scene::flatName() const {
  const std::size_t slash = name.rfind('/');
  if (slash == std::string::npos) return name;
  return safeFileName(name.substr(0, slash)) + "_" + name.substr(slash + 1);
}

}  // namespace v2
}  // namespace synthetic_dataset
