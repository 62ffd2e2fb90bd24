#include "scene_maker.h"

#include <utility>

#include "annotate/mask.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
namespace {

render::LinkSelection selectLinks(const std::vector<world::LinkInstance>& links, int object) {
  render::LinkSelection selection;
  for (const world::LinkInstance& link : links) {
    selection.push_back(link.role != world::Role::kObject || link.object == object);
  }
  return selection;
}

constexpr int kNoObject = -1;

}  // namespace

SceneMaker::SceneMaker(const world::World& world, render::Renderer& renderer,
                       const motion::BagMotion& recording, const std::vector<CameraRig>& cameras,
                       std::string global_frame, const ObjectShapes& shapes,
                       const Requirements& requirements, const MaskOptions& masks)
    : world_(world),
      renderer_(renderer),
      recording_(recording),
      cameras_(cameras),
      global_frame_(std::move(global_frame)),
      shapes_(shapes),
      make_masks_(requirements.silhouettes),
      masks_(masks),
      nothing_(world.links().size(), false),
      without_objects_(selectLinks(world.links(), kNoObject)) {
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    one_object_.push_back(selectLinks(world.links(), static_cast<int>(i)));
  }
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    mask_cameras_.push_back({annotate::Mog2Segmenter(masks.mog2), std::nullopt});
  }
}

Scene SceneMaker::make(std::size_t camera, std::int64_t instant, Stamp stamp,
                       const std::vector<Pose>& X_GO) {
  const CameraRig& rig = cameras_[camera];
  const render::View view{rig.model, cameraPose(rig, world_, recording_, global_frame_, stamp)};
  const auto count = static_cast<std::int64_t>(cameras_.size());
  Scene scene(view.camera);
  scene.index = instant * count + static_cast<std::int64_t>(camera);
  scene.name = (count > 1 ? rig.name + "/" : "") + sceneNumber(instant);
  scene.camera_name = rig.name;
  scene.instant = instant;
  scene.camera_index = camera;
  scene.stamp = stamp;
  scene.X_GC = view.X_WC;
  const std::vector<annotate::ObjectShape> shapes = shapes_.at(world_.linkPoses(), X_GO);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    scene.objects.push_back(annotate::labelObject(shapes[i], X_GO[i], view.X_WC, view.camera));
  }
  if (make_masks_) addMasks(view, mask_cameras_[camera], scene.objects);
  scene.lookup = [this, stamp, X_GC = cameraPoses(stamp)](const std::string& target,
                                                          const std::string& source) {
    const auto inGlobal = [&](const std::string& frame) {
      const auto found = X_GC.find(frame);
      return found != X_GC.end() ? found->second
                                 : recording_.transform(global_frame_, frame, stamp);
    };
    return Pose(inGlobal(target).inverse() * inGlobal(source));
  };
  return scene;
}

std::map<std::string, Pose> SceneMaker::cameraPoses(Stamp stamp) const {
  std::map<std::string, Pose> poses;
  for (const CameraRig& camera : cameras_) {
    poses.emplace(camera.frame, cameraPose(camera, world_, recording_, global_frame_, stamp));
  }
  return poses;
}

void SceneMaker::addMasks(const render::View& view, MaskCamera& camera,
                          std::vector<SceneObject>& objects) {
  const cv::Size size(view.camera.width(), view.camera.height());
  std::vector<cv::Rect> boxes;
  cv::Rect all;  // OpenCV's union with an empty rectangle is the other one
  for (const SceneObject& object : objects) {
    boxes.push_back(object.in_view ? annotate::pixelsOf(*object.loose_box, size) : cv::Rect());
    all |= boxes.back();
  }
  takeBackground(view, all, camera);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    objects[i].silhouette = cv::Mat::zeros(size, CV_8UC1);
    if (boxes[i].empty()) continue;
    cv::Mat alone = camera.background->image.clone();
    drawForMasks(view, one_object_[i], boxes[i])(boxes[i]).copyTo(alone(boxes[i]));
    const cv::Mat raw = camera.segmenter.segment(alone);
    objects[i].silhouette =
        annotate::cutToBox(masks_.clean ? annotate::cleanMask(raw) : raw, *objects[i].loose_box);
  }
}

void SceneMaker::takeBackground(const render::View& view, const cv::Rect& region,
                                MaskCamera& camera) {
  std::optional<Background>& background = camera.background;
  // Compared exactly: a scene's masks must not depend on which scene was made before it.
  const bool stands_still = background && background->X_GC.matrix() == view.X_WC.matrix() &&
                            background->prop_revision == world_.propRevision();
  if (stands_still && (background->region & region) == region) return;
  // MOG2 judges each pixel by itself, so pixels outside of all boxes need not be drawn. Where
  // nothing but the objects moves, the whole picture is good for all scenes to come.
  const cv::Rect whole(0, 0, view.camera.width(), view.camera.height());
  const cv::Rect drawn = stands_still ? whole : region;
  background = Background{view.X_WC, world_.propRevision(), drawn,
                          drawForMasks(view, without_objects_, drawn)};
  camera.segmenter.train(background->image);
}

cv::Mat SceneMaker::drawForMasks(const render::View& view, const render::LinkSelection& drawn,
                                 const cv::Rect& region) {
  // Without shadows, and with pixels sampled at their centres alone, what differs from the
  // background is the object and nothing around it.
  return renderer_.colour(view, world_.linkPoses(),
                          {drawn, nothing_, render::Sampling::kCentre, region});
}

}  // namespace synthetic_dataset
