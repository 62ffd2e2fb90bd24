#include "run/check/visibility_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

/// Why an object is not seen, as messages have it, and how often it is so.
using Reasons = std::map<std::string, int>;

/// The object that is seen most where this one would be; empty: the world.
std::string coveringObject(const Scene& scene, const SceneObject& hidden) {
  std::map<std::uint16_t, int> counts;
  const cv::Mat silhouette = hidden.silhouette().whole();
  const cv::Mat& instances = scene.instance_map();
  for (int v = 0; v < silhouette.rows; ++v) {
    for (int u = 0; u < silhouette.cols; ++u) {
      if (silhouette.at<uchar>(v, u) != 0) ++counts[instances.at<std::uint16_t>(v, u)];
    }
  }
  const auto most =
      std::max_element(counts.begin(), counts.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == counts.end() || most->first == 0) return "";
  for (const SceneObject& object : scene.objects) {
    if (object.instance == most->first) return object.name;
  }
  return "";
}

std::string hiddenBy(const Scene& scene, const SceneObject& object, const NamedRays& rays) {
  const std::string other = coveringObject(scene, object);
  if (!other.empty()) return "hidden by '" + other + "'";
  const Eigen::Vector3d middle_G = *object.X_GO * object.cuboid_O.centre();
  const Eigen::Vector3d sight_G = middle_G - scene.X_GC.translation();
  const auto hit = rays.cast(scene.X_GC.translation(), sight_G, sight_G.norm());
  if (!hit) return "hidden";
  return "hidden by '" + hit->model + "'";
}

/// Kinds of reasons, without figures that differ from scene to scene.
/// @param object  that is in the scene
std::string whyUnseen(const Scene& scene, const SceneObject& object, const NamedRays& rays) {
  const Eigen::Vector3d p_C = *object.X_CO * object.cuboid_O.centre();
  if (!object.in_view || !object.loose_box) {
    return p_C.z() > 0.0 ? "beside the picture" : "behind the camera";
  }
  if (p_C.norm() > scene.camera.far()) return "beyond camera/far";
  if (object.pixels.silhouette_in_image() == 0) {
    return object.truncation() > 0.5 ? "beside the picture" : "smaller than a pixel";
  }
  return hiddenBy(scene, object, rays);
}

std::string textOf(const Reasons& reasons) {
  std::string text;
  for (const auto& [reason, count] : reasons) {
    text += (text.empty() ? "" : ", ") + reason + " in " + std::to_string(count);
  }
  return text;
}

/// The scenes that an object is in.
std::vector<const Scene*> scenesWith(std::size_t object, const std::vector<const Scene*>& scenes) {
  std::vector<const Scene*> with;
  std::copy_if(scenes.begin(), scenes.end(), std::back_inserter(with),
               [&](const Scene* scene) { return scene->objects[object].X_GO.has_value(); });
  return with;
}

/// @param scenes  that it is in, one at least
double nearest(const std::vector<const Scene*>& scenes, std::size_t object) {
  double distance = scenes.front()->objects[object].distance();
  for (const Scene* scene : scenes) {
    distance = std::min(distance, scene->objects[object].distance());
  }
  return distance;
}

/// How many scenes say that an object is not seen: a camera that is put somewhere for each looks at
/// one of them.
std::size_t fewestThatTell(const MotionSetup& motion) {
  const bool is_sampled =
      std::any_of(motion.cameras.begin(), motion.cameras.end(),
                  [](const scene::CameraRig& camera) { return camera.sampled; });
  return is_sampled ? 3 * motion.config.robotCount() : 2;
}

}  // namespace

std::vector<Finding> checkVisibility(const MotionSetup& motion, const NamedRays& rays,
                                     const std::vector<const Scene*>& scenes) {
  std::vector<Finding> findings;
  const std::size_t few = fewestThatTell(motion);
  for (std::size_t i = 0; i < motion.config.objects.size(); ++i) {
    const scene::ObjectOptions& config = motion.config.objects[i];
    if (!config.takes_part || config.is_distractor) continue;
    const std::vector<const Scene*> with_it = scenesWith(i, scenes);
    if (with_it.empty()) continue;
    Reasons reasons;
    std::size_t seen = 0;
    for (const Scene* scene : with_it) {
      const SceneObject& object = scene->objects[i];
      if (object.pixels.visible() > 0) {
        ++seen;
      } else {
        ++reasons[whyUnseen(*scene, object, rays)];
      }
    }
    const std::size_t count = with_it.size();
    const bool is_rare = seen == 0 ? count >= few : seen == 1 && count >= 4 * few;
    if (!is_rare) continue;
    findings.push_back({"not seen", config.name,
                        "seen in " + std::string(seen == 0 ? "none" : "1") + " of " +
                            std::to_string(count) + " scenes: " + textOf(reasons) +
                            "; it is at least " + fixed(nearest(with_it, i), 1) + " m away",
                        "`camera/pose: {position: [x, y, z], look_at: " + config.name +
                            "}` aims the camera at it; the map shows where both are"});
  }
  return findings;
}

}  // namespace synthetic_dataset::run
