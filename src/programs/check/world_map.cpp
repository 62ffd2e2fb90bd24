#include "programs/check/world_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>

#include <Eigen/Geometry>
#include <opencv2/imgproc.hpp>

#include "run/check/moments.h"
#include "run/pictures/floor_plan.h"
#include "run/pictures/map_paper.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::programs {
namespace {

const cv::Scalar kCameraInk(60, 40, 200);

/// Colours that the colour-blind can tell apart (Okabe and Ito 2008), as blue, green, red.
const std::array<cv::Scalar, 5> kWayInks = {cv::Scalar(178, 114, 0), cv::Scalar(115, 158, 0),
                                            cv::Scalar(167, 121, 204), cv::Scalar(0, 159, 230),
                                            cv::Scalar(80, 60, 60)};

/// The path of an object.
struct Way {
  std::string name;
  std::vector<Eigen::Vector3d> points_G;
};

std::vector<Way> waysOf(const run::MotionSetup& motion, const std::vector<run::Moment>& moments) {
  std::vector<Way> ways;
  for (std::size_t i = 0; i < motion.config.objects.size(); ++i) {
    Way way{motion.config.objects[i].name, {}};
    for (const run::Moment& moment : moments) {
      if (moment.X_GO[i]) way.points_G.push_back(moment.X_GO[i]->translation());
    }
    if (!way.points_G.empty()) ways.push_back(std::move(way));
  }
  return ways;
}

std::vector<const Scene*> scenesOfMotion(const run::MotionSetup& motion,
                                         const std::vector<run::FinishedScene>& all) {
  std::vector<const Scene*> scenes;
  for (const run::FinishedScene& each : all) {
    const std::int64_t index = each.scene.instant - motion.first_instant;
    if (index >= 0 && index < motion.instantCount()) scenes.push_back(&each.scene);
  }
  return scenes;
}

/// The area that has to be on the map.
Eigen::AlignedBox2d extentOf(const std::vector<Way>& ways,
                             const std::vector<const Scene*>& scenes) {
  Eigen::AlignedBox2d extent;
  for (const Way& way : ways) {
    for (const Eigen::Vector3d& p_G : way.points_G) extent.extend(Eigen::Vector2d(p_G.head<2>()));
  }
  for (const Scene* scene : scenes) {
    extent.extend(Eigen::Vector2d(scene->X_GC.translation().head<2>()));
  }
  if (extent.isEmpty()) extent.extend(Eigen::Vector2d(0, 0));
  return extent;
}

/// Extends the area to the world's surroundings, but at most to about twice its size.
Eigen::AlignedBox2d withSurroundings(Eigen::AlignedBox2d extent, const world::World& world) {
  const double margin = std::max(3.0, 0.6 * extent.diagonal().norm());
  Eigen::AlignedBox2d most(extent.min() - Eigen::Vector2d(margin, margin),
                           extent.max() + Eigen::Vector2d(margin, margin));
  Eigen::AlignedBox2d seen = extent;
  for (std::size_t i = 0; i < world.links().size(); ++i) {
    if (world.links()[i].role != world::Role::kStatic) continue;
    for (const world::Visual& visual : world.links()[i].link->visuals) {
      const Pose X_GV = world.linkPoses()[i] * visual.X_LV;
      for (const world::Surface& surface : visual.surfaces) {
        for (const Eigen::Vector3f& p : surface.mesh->positions) {
          seen.extend(Eigen::Vector2d((X_GV * Eigen::Vector3d(p.cast<double>())).head<2>()));
        }
      }
    }
  }
  seen = seen.intersection(most);
  constexpr double kEdge = 0.5;  // [m]
  return {seen.min() - Eigen::Vector2d(kEdge, kEdge), seen.max() + Eigen::Vector2d(kEdge, kEdge)};
}

double groundOf(const run::MotionSetup& motion, const std::vector<run::Moment>& moments) {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < motion.config.objects.size(); ++i) {
    if (!motion.config.objects[i].takes_part || motion.config.objects[i].is_distractor) continue;
    const double bottom = motion.shapes->boxesAtRest(i).front().low.z();
    for (const run::Moment& moment : moments) {
      if (moment.X_GO[i]) lowest = std::min(lowest, moment.X_GO[i]->translation().z() + bottom);
    }
  }
  return std::isfinite(lowest) ? lowest : 0.0;
}

/// The outline of what a camera sees of the ground, or of its field of view up to a distance.
std::vector<Eigen::Vector3d> viewCone(const Scene& scene, double ground, double reach) {
  const Eigen::Vector3d eye_G = scene.X_GC.translation();
  std::vector<Eigen::Vector3d> cone;
  constexpr int kSteps = 8;  // per edge of the image
  const double w = scene.camera.width() - 1.0;
  const double h = scene.camera.height() - 1.0;
  const std::array<Eigen::Vector2d, 5> corners = {
      Eigen::Vector2d(0, 0), {w, 0}, {w, h}, {0, h}, {0, 0}};
  for (std::size_t edge = 0; edge < 4; ++edge) {
    for (int i = 0; i < kSteps; ++i) {
      const double t = static_cast<double>(i) / kSteps;
      const auto ray_C = scene.camera.ray((1.0 - t) * corners[edge] + t * corners[edge + 1]);
      if (!ray_C) continue;
      const Eigen::Vector3d ray_G = scene.X_GC.linear() * *ray_C;
      const double fall = (ground - eye_G.z()) / ray_G.z();
      const double across = ray_G.head<2>().norm();
      const bool meets = fall > 0.0 && fall * across < reach;
      const double far = meets ? fall : reach / std::max(across, 1e-3);
      cone.emplace_back(eye_G + far * ray_G);
    }
  }
  return cone;
}

/// How far a cone is drawn: somewhat past the nearest visible object, else over much of the map.
double reachOf(const Scene& scene, const run::MapPaper& paper) {
  double reach = 0.6 * paper.extent().diagonal().norm();
  for (const SceneObject& object : scene.objects) {
    constexpr double kPast = 1.6;
    if (object.pixels.visible() > 0) reach = std::min(reach, kPast * object.distance());
  }
  return reach;
}

/// Whether the camera has moved so far that another cone shows something new.
bool hasMoved(const Pose& one, const Pose& other) {
  constexpr double kFar = 1.0;   // [m]
  constexpr double kWide = 0.3;  // [rad]
  return (one.translation() - other.translation()).norm() > kFar ||
         Eigen::AngleAxisd(one.linear().transpose() * other.linear()).angle() > kWide;
}

void drawCameras(run::MapPaper& paper, const std::vector<const Scene*>& scenes, double ground) {
  constexpr std::size_t kMostCones = 9;
  std::set<std::string> named;
  std::optional<Pose> last;
  std::size_t cones = 0;
  for (const Scene* scene : scenes) {
    const bool is_new = !last || hasMoved(*last, scene->X_GC);
    if (is_new) last = scene->X_GC;
    if (is_new && cones++ < kMostCones)
      paper.shade(viewCone(*scene, ground, reachOf(*scene, paper)), kCameraInk);
  }
  for (const Scene* scene : scenes) {
    const Eigen::Vector3d eye_G = scene->X_GC.translation();
    const Eigen::Vector3d ahead = scene->X_GC.linear().col(2);
    const Eigen::Vector3d tip_G = eye_G + 0.05 * paper.extent().diagonal().norm() * ahead;
    paper.line({eye_G, tip_G}, kCameraInk);
    paper.dot(eye_G, kCameraInk);
  }
  for (const Scene* scene : scenes) {
    if (!named.insert(scene->camera_name).second) continue;
    paper.name(scene->camera_name, scene->X_GC.translation(), kCameraInk);
  }
}

}  // namespace

cv::Mat worldMap(const run::MotionSetup& motion, bool is_only,
                 const std::vector<run::FinishedScene>& all) {
  const std::vector<const Scene*> scenes = scenesOfMotion(motion, all);
  const std::vector<run::Moment> moments = run::momentsOf(motion, scenes);
  const std::vector<Way> ways = waysOf(motion, moments);
  const double ground = groundOf(motion, moments);
  run::MapPaper paper(withSurroundings(extentOf(ways, scenes), *motion.world));
  run::drawFloorPlan(paper, motion.world->links(), motion.world->linkPoses(), ground);
  paper.grid();
  drawCameras(paper, scenes, ground);
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const cv::Scalar& ink = kWayInks[i % kWayInks.size()];
    if (motion.timeline.is_recorded) paper.line(ways[i].points_G, ink);
    if (!motion.timeline.is_recorded) {
      for (const Eigen::Vector3d& p_G : ways[i].points_G) paper.dot(p_G, ink);
    }
    paper.dot(ways[i].points_G.front(), ink);
    paper.name(ways[i].name, ways[i].points_G.front(), ink);
  }
  return paper.finish({(is_only ? "From" : "Motion '" + motion.entry.name + "' from") +
                           " above, in " + motion.frames->globalFrame() + ": x to the right, y up",
                       "dots: where paths begin, and cameras with what they see"});
}

}  // namespace synthetic_dataset::programs
