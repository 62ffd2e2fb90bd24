#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "annotate/mog2_segmenter.h"
#include "annotate/object_labels.h"
#include "camera_rig.h"
#include "motion/bag_motion.h"
#include "object_shapes.h"
#include "render/renderer.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/scene.h"
#include "world/world.h"

namespace synthetic_dataset {

struct MaskOptions {
  annotate::Mog2Options mog2;
  bool clean = true;  ///< fill holes and remove specks
};

/// Labels what a camera sees of the world as it stands: what the writers' requirements ask for, and
/// nothing else.
class SceneMaker {
 public:
  /// All references have to outlive the maker.
  /// @param shapes  of the objects, in the world's order
  SceneMaker(const world::World& world, render::Renderer& renderer,
             const motion::BagMotion& recording, const std::vector<CameraRig>& cameras,
             std::string global_frame, const ObjectShapes& shapes, const Requirements& requirements,
             const MaskOptions& masks);

  /// What a camera's picture shows, of the world as it stands now; the picture itself is left to
  /// the PictureTaker.
  /// @param instant  the place of the scene's time in the timeline
  /// @param X_GO  the objects' poses, in their order
  [[nodiscard]] Scene make(std::size_t camera, std::int64_t instant, Stamp stamp,
                           const std::vector<Pose>& X_GO);

 private:
  /// The picture without objects that masks are found with.
  struct Background {
    Pose X_GC = Pose::Identity();  ///< of the camera, when it was taken
    std::int64_t prop_revision = -1;
    cv::Rect region;  ///< the pixels that were drawn
    cv::Mat image;
  };

  /// What a camera needs to find masks.
  struct MaskCamera {
    annotate::Mog2Segmenter segmenter;
    std::optional<Background> background;
  };

  /// X_GC of all cameras, by their frames.
  [[nodiscard]] std::map<std::string, Pose> cameraPoses(Stamp stamp) const;
  void addMasks(const render::View& view, MaskCamera& camera, std::vector<SceneObject>& objects);
  void takeBackground(const render::View& view, const cv::Rect& region, MaskCamera& camera);
  [[nodiscard]] cv::Mat drawForMasks(const render::View& view, const render::LinkSelection& drawn,
                                     const cv::Rect& region);

  const world::World& world_;
  render::Renderer& renderer_;
  const motion::BagMotion& recording_;
  const std::vector<CameraRig>& cameras_;
  std::string global_frame_;
  const ObjectShapes& shapes_;
  bool make_masks_;
  MaskOptions masks_;
  std::vector<MaskCamera> mask_cameras_;  ///< of cameras_
  render::LinkSelection nothing_;
  render::LinkSelection without_objects_;
  std::vector<render::LinkSelection> one_object_;  ///< the world and this object alone
};

}  // namespace synthetic_dataset
