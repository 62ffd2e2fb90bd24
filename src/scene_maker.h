#pragma once

#include <optional>
#include <string>
#include <vector>

#include "annotate/mog2_segmenter.h"
#include "annotate/object_labels.h"
#include "camera_rig.h"
#include "motion/bag_motion.h"
#include "render/renderer.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/scene.h"
#include "world/world.h"

namespace synthetic_dataset {

struct MaskOptions {
  annotate::Mog2Options mog2;
  bool clean = true;  ///< fill holes and remove specks
};

/// Takes the picture of the world as it stands and labels it: what the writers' requirements ask
/// for, and nothing else.
class SceneMaker {
 public:
  /// All references have to outlive the maker.
  /// @param shapes  the objects, in the world's order
  SceneMaker(const world::World& world, render::Renderer& renderer,
             const motion::BagMotion& recording, CameraRig camera, std::string global_frame,
             std::vector<annotate::ObjectShape> shapes, const Requirements& requirements,
             const MaskOptions& masks);

  /// The scene at a time at which the world stands already.
  /// @param X_GO  the objects' poses, in their order
  [[nodiscard]] Scene make(std::int64_t index, Stamp stamp, const std::vector<Pose>& X_GO);

 private:
  /// The picture without objects that masks are found with.
  struct Background {
    Pose X_GC = Pose::Identity();  ///< of the camera, when it was taken
    std::int64_t prop_revision = -1;
    cv::Rect region;  ///< the pixels that were drawn
    cv::Mat image;
  };

  [[nodiscard]] Pose cameraPose(Stamp stamp) const;
  void addMasks(const render::View& view, std::vector<SceneObject>& objects);
  void takeBackground(const render::View& view, const cv::Rect& region);
  [[nodiscard]] cv::Mat drawForMasks(const render::View& view, const render::LinkSelection& drawn,
                                     const cv::Rect& region);

  const world::World& world_;
  render::Renderer& renderer_;
  const motion::BagMotion& recording_;
  CameraRig camera_;
  std::string global_frame_;
  std::vector<annotate::ObjectShape> shapes_;
  bool make_masks_;
  MaskOptions masks_;
  annotate::Mog2Segmenter segmenter_;
  std::optional<Background> background_;
  render::LinkSelection everything_;
  render::LinkSelection nothing_;
  render::LinkSelection without_objects_;
  std::vector<render::LinkSelection> one_object_;  ///< the world and this object alone
};

}  // namespace synthetic_dataset
