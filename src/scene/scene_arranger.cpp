#include "scene/scene_arranger.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/seconds.h"
#include "scene/camera_poses.h"
#include "scene/placement_map.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/nearest_name.h"
#include "world/mesh/model_geometry.h"

namespace synthetic_dataset::scene {
namespace {

/// How far a box reaches from its frame's origin, seen from above [m].
double radiusOf(const Cuboid& box) {
  const Eigen::Vector3d far = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs());
  return std::hypot(far.x(), far.y());
}

/// The bounding box of each model with a role, in the model's frame, in the world's order.
std::vector<Cuboid> boxesOf(world::Role role, const world::World& world) {
  std::vector<std::vector<const world::Link*>> models;
  std::string last;
  for (const world::LinkInstance& link : world.links()) {
    if (link.role != role) continue;
    if (models.empty() || link.model != last) models.emplace_back();
    models.back().push_back(link.link);
    last = link.model;
  }
  std::vector<Cuboid> boxes;
  for (const std::vector<const world::Link*>& links : models) {
    std::vector<Pose> X_ML;
    for (const world::Link* link : links) X_ML.push_back(link->X_ML);
    boxes.push_back(boxAround(world::ModelGeometry(links).box(X_ML)));
  }
  return boxes;
}

/// The rectangle around everything that stands still and is not an object.
randomize::GroundArea groundArea(const world::World& world) {
  std::vector<const world::Link*> links;
  std::vector<Pose> X_GL;
  for (std::size_t i = 0; i < world.links().size(); ++i) {
    const world::LinkInstance& link = world.links()[i];
    if (link.role != world::Role::kStatic || link.object >= 0) continue;
    links.push_back(link.link);
    X_GL.push_back(world.linkPoses()[i]);
  }
  const world::ModelGeometry geometry(links);
  if (geometry.isEmpty()) {
    throw Error(
        "placement/mode: found ground, and nothing that stands still can be seen in the world; it "
        "should have a ground, or objects be placed in a volume");
  }
  const Cuboid box_G = boxAround(geometry.box(X_GL));
  return {box_G.low.head<2>(), box_G.high.head<2>()};
}

}  // namespace

SceneArranger::SceneArranger(const SceneOptions& config, const std::vector<CameraRig>& cameras,
                             const std::vector<ObjectVariants>& variants,
                             const ObjectShapes& shapes, world::World& world,
                             motion::PlacedFrames& frames, base::Diagnostics& diagnostics)
    : rigs_(cameras),
      world_(world),
      frames_(frames),
      objects_(config.objects.begin(),
               config.objects.begin() + static_cast<std::ptrdiff_t>(config.robotCount())) {
  for (std::size_t i = 0; i < config.objects.size(); ++i) {
    const auto frame = frames.find(config.objects[i].frame).value_or(motion::kNoFrame);
    (i < objects_.size() ? object_frames_ : distractor_frames_).push_back(frame);
  }
  for (std::size_t i = 0; i < objects_.size(); ++i) boxes_O_.push_back(shapes.boxesAtRest(i));
  const bool places_objects = config.isPlaced();
  const bool places_cameras =
      std::any_of(cameras.begin(), cameras.end(), [](const CameraRig& rig) { return rig.sampled; });
  const auto& distractors = config.randomization.distractors;
  if (!places_objects && !places_cameras && !distractors) return;
  if (places_objects) world_.settleProps(config.settling);
  surroundings_.emplace(world_);
  base::Diagnostics errors;
  if (places_objects) errors.attempt([&] { setUpPlacer(config, variants, diagnostics); });
  errors.attempt([&] { setUpCameras(config, cameras); });
  if (distractors) {
    distractor_placer_.emplace(*distractors, boxesOf(world::Role::kDistractor, world_), world_,
                               *surroundings_, static_cast<std::uint64_t>(config.seed));
  }
  errors.throwIfAny();
}

randomize::PlacedObject SceneArranger::describe(std::size_t object, const ObjectVariants& variants,
                                                bool on_map, base::Diagnostics& diagnostics) {
  const ObjectOptions& config = objects_[object];
  randomize::PlacedObject placed{config.name, {}, config.takes_part && !config.stands};
  std::vector<double> reaches;
  for (std::size_t i = 0; i < variants.all().size(); ++i) {
    const Cuboid& box_O = boxes_O_[object][i];
    reaches.push_back(radiusOf(box_O));
    const double own_radius = on_map ? reaches.back() : 0.0;
    const auto& given = config.safety_radius;
    placed.rooms.push_back({given ? *given * variants.all()[i].scale : own_radius, box_O});
  }
  if (placed.takes_part && on_map && !config.safety_radius) {
    const auto [low, high] = std::minmax_element(reaches.begin(), reaches.end());
    diagnostics.note(config.name + "/safety_radius",
                     fixed(*low, 3) + (*low < *high ? " to " + fixed(*high, 3) : "") +
                         " m, how far the model reaches");
  }
  return placed;
}

void SceneArranger::setUpPlacer(const SceneOptions& config,
                                const std::vector<ObjectVariants>& variants,
                                base::Diagnostics& diagnostics) {
  const bool on_map = config.placement.mode == randomize::PlacementMode::kMap;
  if (on_map && !config.placement.map_file && !config.placement.map_topic)
    return;  // reported already
  std::optional<randomize::OccupancyMap> map;
  if (on_map) map = readPlacementMap(config, diagnostics);
  randomize::PlacementOptions options = config.placement;
  const bool on_ground = options.mode == randomize::PlacementMode::kGround;
  if (on_ground && !options.area) options.area = groundArea(world_);
  std::vector<randomize::PlacedObject> placed;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    placed.push_back(describe(i, variants[i], on_map, diagnostics));
  }
  placer_.emplace(options, map, std::move(placed), world_, *surroundings_,
                  static_cast<std::uint64_t>(config.seed));
}

void SceneArranger::setUpCameras(const SceneOptions& config,
                                 const std::vector<CameraRig>& cameras) {
  for (const CameraRig& rig : cameras) {
    if (!rig.sampled) continue;
    const auto camera =
        std::find_if(config.cameras.begin(), config.cameras.end(),
                     [&](const CameraOptions& each) { return each.name == rig.name; });
    std::vector<std::string> targets{"any", "all"};
    for (const ObjectOptions& object : objects_) {
      if (object.takes_part) targets.push_back(object.name);
    }
    const std::string& look_at = camera->sample->look_at;
    const bool is_told = look_at.empty();  // a look_at that is not a text was reported already
    if (!is_told && std::find(targets.begin(), targets.end(), look_at) == targets.end()) {
      throw Error(camera->group + "/sample/look_at: found '" + look_at +
                  "'; it should be any, all, an object of robot_list or a point [x, y, z]" +
                  didYouMean(look_at, targets));
    }
    cameras_.push_back({rig.followed,
                        camera->group,
                        {*camera->sample, camera->group, world_, *surroundings_,
                         static_cast<std::uint64_t>(config.seed)}});
  }
}

void SceneArranger::placeObjects(std::int64_t instant) {
  if (!placer_) return;
  const std::vector<std::optional<Pose>> X_GO = placer_->place(instant);
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (!objects_[i].stands) frames_.place(object_frames_[i], X_GO[i]);
  }
}

void SceneArranger::followProps() {
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const bool stands = objects_[i].takes_part && objects_[i].stands;
    if (stands) frames_.place(object_frames_[i], world_.worldModelPose(i));
  }
}

void SceneArranger::placeDistractors(std::int64_t instant, Stamp stamp) {
  if (!distractor_placer_) return;
  // Cameras that are placed afterwards keep their distance themselves.
  std::vector<Eigen::Vector3d> cameras_G;
  for (const CameraRig& rig : rigs_) {
    if (rig.sampled) continue;
    cameras_G.push_back(cameraPose(rig, world_, frames_, stamp).X_GC.translation());
  }
  distractors_there_ = distractor_placer_->place(instant, cameras_G, objectBoxes(stamp));
  const std::vector<std::optional<Pose>> X_GM = world_.distractorPoses();
  for (std::size_t i = 0; i < distractor_frames_.size(); ++i) {
    frames_.place(distractor_frames_[i], X_GM[i]);
  }
}

/// The objects' current bounding boxes along the global frame's axes; absent objects included, so
/// that the distractors around them do not reveal which objects are absent.
std::vector<Cuboid> SceneArranger::objectBoxes(Stamp stamp) const {
  std::vector<Cuboid> boxes_G;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (!objects_[i].takes_part) continue;
    const auto X_GO = frames_.pose(object_frames_[i], stamp);
    if (!X_GO) continue;
    std::vector<Eigen::Vector3d> corners_G;
    for (const Eigen::Vector3d& corner : boxes_O_[i][world_.variant(i)].corners()) {
      corners_G.emplace_back(*X_GO * corner);
    }
    boxes_G.push_back(boxAround(corners_G));
  }
  return boxes_G;
}

std::vector<base::Warning> SceneArranger::placeCameras(std::int64_t instant, Stamp stamp) {
  if (cameras_.empty()) return {};
  std::vector<randomize::CameraTarget> targets;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const auto X_GO = frames_.pose(object_frames_[i], stamp);
    if (!objects_[i].takes_part || !X_GO) continue;
    const Cuboid& box_O = boxes_O_[i][world_.variant(i)];
    const Eigen::Vector3d centre_O = 0.5 * (box_O.low + box_O.high);
    targets.push_back(
        {objects_[i].name, *X_GO * centre_O, world_.isPresent(i), (box_O.high - box_O.low).norm()});
  }
  std::vector<base::Warning> warnings;
  for (const SampledCamera& camera : cameras_) {
    const randomize::SampledPose sampled = camera.sampler.sample(instant, targets);
    frames_.place(camera.frame, sampled.X_GC);
    if (sampled.hidden.empty()) continue;
    warnings.push_back({camera.group +
                            "/sample: something hides what the camera looks at from all positions "
                            "that were tried (is it inside a wall?); the camera is at the first "
                            "free one",
                        "of scene " + std::to_string(instant) + "'s, " + sampled.hidden});
  }
  return warnings;
}

}  // namespace synthetic_dataset::scene
