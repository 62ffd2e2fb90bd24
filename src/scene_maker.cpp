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
                       const motion::BagMotion& recording, CameraRig camera,
                       std::string global_frame, std::vector<annotate::ObjectShape> shapes,
                       const Requirements& requirements, const MaskOptions& masks)
    : world_(world),
      renderer_(renderer),
      recording_(recording),
      camera_(std::move(camera)),
      global_frame_(std::move(global_frame)),
      shapes_(std::move(shapes)),
      make_masks_(requirements.instance_masks),
      masks_(masks),
      segmenter_(masks.mog2),
      everything_(world.links().size(), true),
      nothing_(world.links().size(), false),
      without_objects_(selectLinks(world.links(), kNoObject)) {
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    one_object_.push_back(selectLinks(world.links(), static_cast<int>(i)));
  }
}

Scene SceneMaker::make(std::int64_t index, Stamp stamp, const std::vector<Pose>& X_GO) {
  const render::View view{camera_.model, cameraPose(stamp)};
  Scene scene{index, sceneNumber(index), "camera", stamp, view.camera, view.X_WC, {}, {}, {}};
  scene.image = renderer_.colour(view, world_.linkPoses(), {everything_, everything_});
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    scene.objects.push_back(annotate::labelObject(shapes_[i], X_GO[i], view.X_WC, view.camera));
  }
  if (make_masks_) addMasks(view, scene.objects);
  scene.lookup = [this, stamp, X_GC = view.X_WC](const std::string& target,
                                                 const std::string& source) {
    const auto inGlobal = [&](const std::string& frame) {
      if (frame == camera_.frame) return X_GC;
      return recording_.transform(global_frame_, frame, stamp);
    };
    return Pose(inGlobal(target).inverse() * inGlobal(source));
  };
  return scene;
}

Pose SceneMaker::cameraPose(Stamp stamp) const {
  return camera_.X_GC ? *camera_.X_GC : recording_.transform(global_frame_, camera_.frame, stamp);
}

void SceneMaker::addMasks(const render::View& view, std::vector<SceneObject>& objects) {
  const cv::Size size(view.camera.width(), view.camera.height());
  std::vector<cv::Rect> boxes;
  cv::Rect all;  // OpenCV's union with an empty rectangle is the other one
  for (const SceneObject& object : objects) {
    boxes.push_back(object.in_view ? annotate::pixelsOf(*object.loose_box, size) : cv::Rect());
    all |= boxes.back();
  }
  takeBackground(view, all);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    objects[i].mask = cv::Mat::zeros(size, CV_8UC1);
    if (boxes[i].empty()) continue;
    cv::Mat alone = background_->image.clone();
    drawForMasks(view, one_object_[i], boxes[i])(boxes[i]).copyTo(alone(boxes[i]));
    const cv::Mat raw = segmenter_.segment(alone);
    objects[i].mask =
        annotate::cutToBox(masks_.clean ? annotate::cleanMask(raw) : raw, *objects[i].loose_box);
  }
}

void SceneMaker::takeBackground(const render::View& view, const cv::Rect& region) {
  // Compared exactly: a scene's masks must not depend on which scene was made before it.
  const bool stands_still = background_ && background_->X_GC.matrix() == view.X_WC.matrix() &&
                            background_->prop_revision == world_.propRevision();
  if (stands_still && (background_->region & region) == region) return;
  // MOG2 judges each pixel by itself, so pixels outside of all boxes need not be drawn. Where
  // nothing but the objects moves, the whole picture is good for all scenes to come.
  const cv::Rect whole(0, 0, view.camera.width(), view.camera.height());
  const cv::Rect drawn = stands_still ? whole : region;
  background_ = Background{view.X_WC, world_.propRevision(), drawn,
                           drawForMasks(view, without_objects_, drawn)};
  segmenter_.train(background_->image);
}

cv::Mat SceneMaker::drawForMasks(const render::View& view, const render::LinkSelection& drawn,
                                 const cv::Rect& region) {
  // Without shadows, and with pixels sampled at their centres alone, what differs from the
  // background is the object and nothing around it.
  return renderer_.colour(view, world_.linkPoses(),
                          {drawn, nothing_, render::Sampling::kCentre, region});
}

}  // namespace synthetic_dataset
