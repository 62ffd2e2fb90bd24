#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "motion/frame_source.h"
#include "scene/articulation.h"
#include "scene/object_options.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

/// The poses of objects and their links at any time: those of their frames, or, during a gap, the
/// last known ones, unless objects are absent then (WhenUnknown). A link whose frame is not known
/// keeps its last pose relative to its parent link, initially that of the model at rest.
class ObjectMotion {
 public:
  /// @param frames  has to outlive this
  /// @param links  of the world; their Link objects have to outlive this
  /// @param driven  the driven links of each object's variants
  ObjectMotion(const motion::FrameSource& frames, const std::vector<ObjectOptions>& objects,
               const std::vector<world::LinkInstance>& links,
               const std::vector<std::vector<DrivenLinks>>& driven);

  /// @param moving_object  an object's variant: its index among the variants of all objects
  /// @return nothing if its frame has not been known yet, or if it is absent
  [[nodiscard]] std::optional<world::ObjectPose> at(int moving_object, Stamp time);

  /// X_GO of all objects; nothing for those whose frames have not been known yet.
  [[nodiscard]] std::vector<std::optional<Pose>> objectPoses(Stamp time);

  /// Descriptions of the links whose frames were unknown at some time since the last call.
  [[nodiscard]] std::set<std::string> takeGaps();

 private:
  struct LinkState {
    std::string name;
    std::optional<std::size_t> parent;
    std::optional<motion::FrameId> frame;  ///< if it is driven
    Pose X_PL = Pose::Identity();          ///< last known, in the parent's frame or the object's
  };
  struct Object {
    std::string name;
    motion::FrameId frame;
    bool may_be_absent;             ///< when its pose is unknown; otherwise it stays where it was
    std::optional<Pose> X_GO = {};  ///< last known
  };
  struct Variant {
    std::size_t object;
    std::vector<LinkState> links;
    std::vector<std::size_t> order;  ///< of the links: parents before children
    std::vector<std::size_t> driven;
  };

  [[nodiscard]] static Variant makeVariant(std::size_t object,
                                           const std::vector<const world::Link*>& links,
                                           const DrivenLinks& driven);
  [[nodiscard]] const std::optional<Pose>& objectPose(Object& object, Stamp time) const;
  [[nodiscard]] Pose linkPose(const Object& object, LinkState& link, const Pose& X_GP, Stamp time);

  const motion::FrameSource& frames_;
  std::vector<Object> objects_;
  std::vector<Variant> variants_;  ///< of all objects, object by object
  std::set<std::string> gaps_;     ///< a set, as variants have the same ones
};

}  // namespace synthetic_dataset::scene
