#include "run/check/camera_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

using Links = std::set<std::size_t>;

/// Links that also enclose objects, such as a hall modelled as one shell: a camera may be inside
/// these.
Links shellsAround(const NamedRays& rays, const std::vector<const Scene*>& scenes) {
  Links shells;
  for (const Scene* scene : scenes) {
    for (const SceneObject& object : scene->objects) {
      if (!object.X_GO) continue;
      const Links around = rays.around(*object.X_GO * object.cuboid_O.centre());
      shells.insert(around.begin(), around.end());
    }
  }
  return shells;
}

/// The model, other than the shells, that encloses a point.
std::optional<std::string> modelAround(const NamedRays& rays, const Links& shells,
                                       const Eigen::Vector3d& p_G) {
  for (const std::size_t link : rays.around(p_G)) {
    if (shells.count(link) == 0) return rays.modelOf(link);
  }
  return std::nullopt;
}

/// The model of an infinite plane that lies above a point.
std::optional<std::string> groundAbove(const world::World& world, const Eigen::Vector3d& p_G) {
  for (std::size_t i = 0; i < world.links().size(); ++i) {
    const world::LinkInstance& link = world.links()[i];
    if (link.role != world::Role::kStatic) continue;
    for (const world::Collision& collision : link.link->collisions) {
      const auto* plane = std::get_if<world::PlaneShape>(&collision.shape);
      if (plane == nullptr) continue;
      const Eigen::Vector3d p_C = (world.linkPoses()[i] * collision.X_LC).inverse() * p_G;
      if (p_C.dot(plane->normal) < 0.0) return link.model;
    }
  }
  return std::nullopt;
}

/// The model that covers most of the lens from so close that little else is visible.
std::optional<std::string> modelBefore(const NamedRays& rays, const Scene& scene) {
  constexpr double kNear = 0.15;  // [m]
  constexpr int kSteps = 5;       // per side of a grid of pixels
  std::map<std::string, int> counts;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const auto ray_C = scene.camera.ray({(i + 0.5) / kSteps * scene.camera.width() - 0.5,
                                           (j + 0.5) / kSteps * scene.camera.height() - 0.5});
      if (!ray_C) continue;
      const auto hit = rays.cast(scene.X_GC.translation(), scene.X_GC.linear() * *ray_C, kNear);
      if (hit) ++counts[hit->model];
    }
  }
  for (const auto& [model, count] : counts) {
    if (2 * count > kSteps * kSteps) return model;
  }
  return std::nullopt;
}

/// The object that fills nearly the whole picture.
std::optional<std::string> objectBefore(const Scene& scene) {
  constexpr double kNearlyAll = 0.9;
  const double pixels = static_cast<double>(scene.camera.width()) * scene.camera.height();
  for (const SceneObject& object : scene.objects) {
    if (static_cast<double>(object.pixels.visible()) > kNearlyAll * pixels) return object.name;
  }
  return std::nullopt;
}

/// Describes what is wrong with a camera's place in a scene.
std::optional<std::string> wrongPlace(const MotionSetup& motion, const NamedRays& rays,
                                      const Links& shells, const Scene& scene) {
  const Eigen::Vector3d p_G = scene.X_GC.translation();
  if (const auto model = modelAround(rays, shells, p_G)) return "is inside of '" + *model + "'";
  if (const auto model = groundAbove(*motion.world, p_G)) return "is below '" + *model + "'";
  if (const auto model = modelBefore(rays, scene)) {
    return "has '" + *model + "' less than 0.15 m in front of most of its lens";
  }
  if (const auto object = objectBefore(scene)) {
    return "sees nothing but '" + *object + "', or is inside of it";
  }
  return std::nullopt;
}

std::string pointText(const Eigen::Vector3d& p_G) {
  return "[" + fixed(p_G.x(), 2) + ", " + fixed(p_G.y(), 2) + ", " + fixed(p_G.z(), 2) + "]";
}

/// Reasons why an object is not seen, as worded in messages, with their counts.
using Reasons = std::map<std::string, int>;

/// The object that covers most of where this one would be; empty: the world.
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

/// The kind of reason, without figures that differ from scene to scene.
/// @param object  must be in the scene
std::string whyUnseen(const Scene& scene, const SceneObject& object, const NamedRays& rays) {
  const Eigen::Vector3d p_C = *object.X_CO * object.cuboid_O.centre();
  if (!object.inView(scene.camera)) {
    return p_C.z() > 0.0 ? "outside the picture" : "behind the camera";
  }
  if (p_C.norm() > scene.camera.far()) return "beyond camera/far";
  if (object.pixels.silhouette_in_image() == 0) {
    return object.truncation() > 0.5 ? "outside the picture" : "smaller than a pixel";
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

/// The scenes that contain an object.
std::vector<const Scene*> scenesWith(std::size_t object, const std::vector<const Scene*>& scenes) {
  std::vector<const Scene*> with;
  std::copy_if(scenes.begin(), scenes.end(), std::back_inserter(with),
               [&](const Scene* scene) { return scene->objects[object].X_GO.has_value(); });
  return with;
}

/// @param scenes  at least one; all contain the object
double nearest(const std::vector<const Scene*>& scenes, std::size_t object) {
  double distance = scenes.front()->objects[object].distance();
  for (const Scene* scene : scenes) {
    distance = std::min(distance, scene->objects[object].distance());
  }
  return distance;
}

/// Finds cameras whose pictures are upside down nearly all of the time.
std::vector<Finding> upsideDown(const std::vector<const Scene*>& scenes) {
  constexpr double kSteep = 0.8;    // a camera that looks this steeply up or down has no horizon
  constexpr double kUpright = 0.5;  // the sine of 30 degrees
  struct Count {
    std::size_t scenes = 0;
    std::size_t upside_down = 0;
  };
  std::map<std::string, Count> cameras;
  for (const Scene* scene : scenes) {
    const Eigen::Matrix3d R_GC = scene->X_GC.linear();
    Count& count = cameras[scene->camera_name];
    ++count.scenes;
    if (std::abs(R_GC(2, 2)) < kSteep && R_GC(2, 1) > kUpright) ++count.upside_down;
  }
  std::vector<Finding> findings;
  for (const auto& [name, count] : cameras) {
    if (count.upside_down == 0 || 10 * count.upside_down < 9 * count.scenes) continue;
    findings.push_back({"upside down", name == "camera" ? name : "camera " + name,
                        "its picture is upside down in " + std::to_string(count.upside_down) +
                            " of " + std::to_string(count.scenes) +
                            " scenes: the optical frame's y axis, which is down in the picture, "
                            "points up",
                        "its roll should differ by half a turn (3.1416, deg(180)); if it is "
                        "mounted so on purpose, ignore this"});
  }
  return findings;
}

/// The minimum number of scenes for concluding that an object is not seen: a camera that is placed
/// anew for each scene only looks at one object.
std::size_t minScenesToConclude(const MotionSetup& motion) {
  const bool is_sampled =
      std::any_of(motion.cameras.begin(), motion.cameras.end(),
                  [](const scene::CameraRig& camera) { return camera.sampled; });
  return is_sampled ? 3 * motion.config.robotCount() : 2;
}

/// Whether other objects stand in for this one: a passing camera sees only some of the objects that
/// stand in the world, so the first of a class is reported for all, and only if none is seen.
bool isReportedByAnother(const MotionSetup& motion, std::size_t object,
                         const std::vector<const Scene*>& scenes) {
  const std::vector<scene::ObjectOptions>& objects = motion.config.objects;
  if (!objects[object].stands) return false;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!objects[i].stands || objects[i].class_id != objects[object].class_id) continue;
    const bool is_seen = std::any_of(scenes.begin(), scenes.end(), [&](const Scene* scene) {
      return scene->objects[i].pixels.visible() > 0;
    });
    if (is_seen || i < object) return true;
  }
  return false;
}

/// The remedy for an object that is not seen.
/// @param object  its index
std::string cureOfUnseen(const MotionSetup& motion, std::size_t object, const Reasons& reasons) {
  const std::string& name = motion.config.objects[object].name;
  const bool is_looked_at =
      std::any_of(motion.cameras.begin(), motion.cameras.end(), [&](const scene::CameraRig& each) {
        return each.looks_at && each.looks_at->object == object;
      });
  if (!is_looked_at) {
    return "`camera/pose: {position: [x, y, z], look_at: " + name +
           "}` aims the camera at it; the map shows where both are";
  }
  const auto most = std::max_element(
      reasons.begin(), reasons.end(),
      [](const auto& one, const auto& other) { return one.second < other.second; });
  const std::string& reason = most->first;
  if (reason == "smaller than a pixel") {
    return "the camera looks at it already: a nearer position would help, or a larger model, if "
           "its mesh is in millimetres and was read as if in metres, or the other way round";
  }
  if (reason == "beyond camera/far") {
    return "the camera looks at it already: a greater camera/far or a nearer position would help";
  }
  return "the camera looks at it already: a position from which nothing hides it would help; the "
         "map shows where both are";
}

}  // namespace

std::vector<Finding> checkCameras(const MotionSetup& motion, const NamedRays& rays,
                                  const std::vector<const Scene*>& scenes) {
  struct Places {
    int count = 0;
    std::string first;
  };
  const Links shells = shellsAround(rays, scenes);
  std::map<std::pair<std::string, std::string>, Places> wrong;  // by camera and description
  for (const Scene* scene : scenes) {
    const auto words = wrongPlace(motion, rays, shells, *scene);
    if (!words) continue;
    Places& places = wrong[{scene->camera_name, *words}];
    if (places.count++ == 0) places.first = pointText(scene->X_GC.translation());
  }
  std::vector<Finding> findings;
  for (const auto& [where, places] : wrong) {
    const std::string& camera = where.first;
    findings.push_back({"camera's place", camera == "camera" ? camera : "camera " + camera,
                        where.second + " in " + std::to_string(places.count) + " of " +
                            std::to_string(scenes.size()) + " scenes, first at " + places.first,
                        "the map shows where it stands; its pose, or its frame in the recording, "
                        "should be changed"});
  }
  for (Finding& each : upsideDown(scenes)) findings.push_back(std::move(each));
  return findings;
}

std::vector<Finding> checkLights(const MotionSetup& motion, const NamedRays& rays,
                                 const std::vector<const Scene*>& scenes) {
  const Links shells = shellsAround(rays, scenes);
  std::vector<Finding> findings;
  for (const world::Light& light : motion.world->description().lights) {
    // A body around a point light is its bulb, which does not block the light.
    if (light.type != world::LightType::kSpot || !light.casts_shadow) continue;
    const Eigen::Vector3d p_G = light.X_WL.translation();
    const auto model = modelAround(rays, shells, p_G);
    if (!model) continue;
    findings.push_back({"light inside", "light " + light.name,
                        "at " + pointText(p_G) + " it is inside of '" + *model +
                            "', and casts shadows: none of its light gets out",
                        "its <pose> in the world should be outside, or <cast_shadows> false"});
  }
  return findings;
}

std::vector<Finding> checkVisibility(const MotionSetup& motion, const NamedRays& rays,
                                     const std::vector<const Scene*>& scenes) {
  std::vector<Finding> findings;
  const std::size_t few = minScenesToConclude(motion);
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
    if (!is_rare || isReportedByAnother(motion, i, scenes)) continue;
    findings.push_back({"not seen", config.name,
                        "seen in " + std::string(seen == 0 ? "none" : "1") + " of " +
                            std::to_string(count) + " scenes: " + textOf(reasons) +
                            "; it is at least " + fixed(nearest(with_it, i), 1) + " m away",
                        cureOfUnseen(motion, i, reasons)});
  }
  return findings;
}

}  // namespace synthetic_dataset::run
