#include "scene/scene_maker.h"

#include <limits>
#include <utility>

#include "label/optical_flow.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::scene {

SceneMaker::SceneMaker(const world::World& world, render::Renderer& renderer,
                       const motion::PlacedFrames& frames, const std::vector<CameraRig>& cameras,
                       const ObjectShapes& shapes, const Requirements& requirements,
                       const label::PixelLabelOptions& options)
    : world_(world),
      frames_(frames),
      cameras_(cameras),
      shapes_(shapes),
      needs_optical_flow_(requirements.optical_flow) {
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    labellers_.emplace_back(world, renderer, shapes.size(), requirements, options);
  }
}

SeenScene SceneMaker::look(std::size_t camera, std::int64_t instant, Stamp stamp,
                           CameraPoses& poses, std::vector<std::optional<Pose>> X_GO,
                           const std::map<std::string, Pose>& X_GF) {
  SeenScene seen = begin(camera, instant, stamp, poses, std::move(X_GO), X_GF);
  const render::View view{seen.scene.camera, seen.scene.X_GC};
  seen.pixels = labellers_[camera].look({view, world_}, seen.scene);
  return seen;
}

SeenScene SceneMaker::begin(std::size_t camera, std::int64_t instant, Stamp stamp,
                            CameraPoses& poses, std::vector<std::optional<Pose>> X_GO,
                            const std::map<std::string, Pose>& X_GF) const {
  const CameraRig& rig = cameras_[camera];
  const render::View view{rig.model, poses.of(camera).X_GC};
  const auto count = static_cast<std::int64_t>(cameras_.size());
  Scene scene(view.camera);
  scene.index = instant * count + static_cast<std::int64_t>(camera);
  scene.name = (count > 1 ? rig.name + "/" : "") + sceneNumber(instant);
  scene.camera_name = rig.name;
  scene.instant = instant;
  scene.camera_index = camera;
  scene.stamp = stamp;
  scene.X_GC = view.X_WC;
  for (std::size_t i = 0; i < X_GO.size(); ++i) {
    if (!world_.isPresent(i)) X_GO[i].reset();
  }
  const std::vector<label::ObjectShape> shapes = shapes_.at(X_GO);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    scene.objects.push_back(label::labelObject(shapes[i], X_GO[i], view.X_WC, view.camera));
  }
  std::map<std::string, Pose> placed = posesByFrame(poses);
  placed.insert(X_GF.begin(), X_GF.end());
  // Writers call this in their own thread, when the next scene may already have been placed.
  scene.setTransforms([frames = frames_, stamp, placed = std::move(placed)](
                          const std::string& target, const std::string& source) {
    const auto inGlobal = [&](const std::string& frame) {
      const auto found = placed.find(frame);
      if (found != placed.end()) return found->second;
      const auto id = frames.find(frame);
      if (!id) throw Error(frames.lacks(frame));
      return frames.knownPose(*id, stamp);
    };
    return Pose(inGlobal(target).inverse() * inGlobal(source));
  });
  return {std::move(scene), {}, needs_optical_flow_ ? world_.linkPoses() : std::vector<Pose>{}};
}

void SceneMaker::lookInRows(SeenScene& seen, label::CapturedRows taken) {
  Scene& scene = seen.scene;
  seen.pixels = labellers_[scene.camera_index].look({taken, world_}, scene);
  if (needs_optical_flow_) seen.rows = std::move(taken.view);
}

void SceneMaker::addOpticalFlow(SeenScene& seen, CameraPoses* next) const {
  Scene& scene = seen.scene;
  if (next == nullptr) {
    scene.optical_flow = cv::Mat(scene.camera.height(), scene.camera.width(), CV_32FC2,
                                 cv::Scalar::all(std::numeric_limits<double>::quiet_NaN()));
    return;
  }
  const label::SeenSurface& surface = seen.pixels.surface;
  const CameraRig& rig = cameras_[scene.camera_index];
  scene.optical_flow = label::opticalFlow(scene.camera, surface.depth, surface.range, surface.links,
                                          scene.X_GC, seen.X_GL, rig.model,
                                          next->of(scene.camera_index).X_GC, world_.linkPoses());
}

void SceneMaker::addOpticalFlowInRows(SeenScene& seen, const render::RollingView& next) {
  const label::SeenSurface& surface = seen.pixels.surface;
  seen.scene.optical_flow =
      label::opticalFlow(seen.rows.value(), surface.range, surface.links, next);
}

std::vector<base::ObjectFacts> SceneMaker::objectFacts(
    const Scene& scene, const label::MaskAgreement& agreement) const {
  std::vector<base::ObjectFacts> all;
  for (const SceneObject& object : scene.objects) {
    base::ObjectFacts facts = base::objectFacts(object);
    if (all.size() < agreement.size()) facts.mask_agreement = agreement[all.size()];
    all.push_back(std::move(facts));
  }
  return all;
}

std::map<std::string, Pose> SceneMaker::posesByFrame(CameraPoses& poses) const {
  std::map<std::string, Pose> by_frame;
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    by_frame.emplace(cameras_[i].frame, poses.of(i).X_GF);
    by_frame.emplace(cameras_[i].optical_frame, poses.of(i).X_GC);
  }
  return by_frame;
}

}  // namespace synthetic_dataset::scene
