#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/pose.h"
#include "world/description.h"
#include "world/physics/object_bodies.h"
#include "world/world_options.h"

namespace synthetic_dataset::world {

enum class Role {
  kStatic,      ///< stays where its file puts it
  kProp,        ///< moved by physics
  kObject,      ///< follows TF, and is labelled
  kDistractor,  ///< placed anew from time to time
};

/// One link of one model in the running world.
struct LinkInstance {
  const Link* link = nullptr;  ///< lives as long as the world
  Role role = Role::kStatic;
  int object = -1;          ///< index of the object, or labelled distractor, else -1; static models
                            ///< and props may be objects, too
  std::string model = "";   ///< the name of its model
  std::size_t variant = 0;  ///< index among its object's variants
};

/// Two bodies that overlap.
struct Interpenetration {
  std::string first;   ///< an object's name
  std::string second;  ///< an object's or a static model's name
  double depth = 0.0;  ///< [m], > 0
};

/// The world in motion (simulated by Bullet): objects are placed where the recording says, static
/// models stay, props fall, settle and are pushed. The same calls give the same poses, bit for bit,
/// and so do calls that reach the same time in different strides.
///
/// Models that are neither objects nor static are props, each a single rigid body whose links keep
/// the relative poses given in the file. An object is one kinematic body or, if TF drives its
/// links, several, which are never reported as overlapping one another. It may have several models,
/// its variants, of which one is active at a time; only that one is seen and touched. One of the
/// world's own models may also be an object: it is labelled, but otherwise remains a static model
/// or a prop. Meshes of props and objects collide as their convex hulls, those of static models as
/// their triangles. A prop without any collision that could support it (Gazebo would let it fall
/// for ever) stays where it is and counts as static; a prop that falls off the world stops after 10
/// km.
class World {
 public:
  /// Returns where a variant and its driven links are at a time; nothing while they are not in the
  /// world and push nothing. Variants are numbered consecutively across all objects: those of the
  /// first object, then those of the second. Called for active variants at every step of the
  /// simulation, so it has to answer for any time between two scenes; for the others only at the
  /// times of advanceTo.
  using ObjectPoseAt = std::function<std::optional<ObjectPose>(int variant, Stamp time)>;

  /// @param description  models that are neither objects nor static are props
  /// @param objects  in the order of `robot_list`; their models' poses are ignored
  /// @param distractors  absent until they are placed; they push nothing
  /// @throws ErrorList with every collision shape or mass that cannot be simulated, and its model
  World(Description description, std::vector<MovingObject> objects, const PhysicsOptions& options,
        std::vector<Model> distractors = {});
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Advances the world to `time`. The first call sets the clock: props start there, at rest. Later
  /// calls simulate the whole steps in between, with the objects moving along; over the remaining
  /// fraction of a step, a moving prop is extrapolated along its velocity. Without props, `time`
  /// may also go back.
  /// @throws Error if there are props and `time` is earlier than the previous one, if an object's
  ///     pose is not finite or does not have one pose per driven link, or if the simulation breaks
  ///     down (naming the prop); the world is unusable afterwards
  void advanceTo(Stamp time, const ObjectPoseAt& motion);

  /// Shows the world in the state that another one with the same motion reached at `time`; nothing
  /// is simulated. A world on which this was called must not be advanced any more.
  /// @param X_WM  of the props, as from propPoses
  /// @param X_WO  of all objects' variants, numbered as for ObjectPoseAt
  /// @throws Error as advanceTo if a pose is missing or not finite
  void showAt(Stamp time, const std::vector<Pose>& X_WM,
              const std::vector<std::optional<ObjectPose>>& X_WO);

  /// X_WM of each prop, in order, as shown.
  [[nodiscard]] std::vector<Pose> propPoses() const;

  /// Sets which objects are present from now on; initially, all are. An absent object has no
  /// pixels, overlaps nothing and does not fall, but still pushes props.
  /// @param present  for each object
  void setPresent(const std::vector<bool>& present);

  /// @param object  index of an object or labelled distractor
  [[nodiscard]] bool isPresent(std::size_t object) const;

  /// Sets the active variant of each object from now on; initially, the one with index 0.
  /// @param variants  index for each object, in range
  void setVariants(const std::vector<std::size_t>& variants);

  /// The active variant of an object; 0 for a labelled distractor, which has no other.
  [[nodiscard]] std::size_t variant(std::size_t object) const;

  /// Lets distractors fall from X_WM, each as one rigid body, among everything that is present now
  /// and stays still meanwhile. Requires PhysicsOptions::drops_distractors.
  /// @param X_WM  of the distractors that fall
  /// @return where the ones that have come to rest within `time` lie; nothing for all others
  [[nodiscard]] std::vector<std::optional<Pose>> dropDistractors(
      const std::vector<std::optional<Pose>>& X_WM, Duration time) const;

  /// Places the distractors until the next call: X_WM of each; nothing for one that is absent.
  void placeDistractors(const std::vector<std::optional<Pose>>& X_WM);

  /// X_WM of each distractor that is present; nothing for the others.
  [[nodiscard]] std::vector<std::optional<Pose>> distractorPoses() const;

  /// X_WM, as shown, of an object that is one of the world's own models; nothing for other objects.
  [[nodiscard]] std::optional<Pose> worldModelPose(std::size_t object) const;

  /// The name of something that a distractor would overlap at X_WM: a static model, a prop or a
  /// present object where they are now, or an earlier distractor where `X_WM_before` puts it.
  [[nodiscard]] std::optional<std::string> obstacleOfDistractor(
      std::size_t distractor, const Pose& X_WM,
      const std::vector<std::optional<Pose>>& X_WM_before) const;

  /// Whether each link is seen now: those of static models and props always are, those of active
  /// variants and distractors while they are present.
  [[nodiscard]] const std::vector<bool>& presentLinks() const;

  /// Puts everything back to where it started and resets the clock: the next advanceTo counts as
  /// the first.
  void restart();

  /// Lets the props fall and come to rest without the objects, for at most `time`; from now on they
  /// start from where they lie then. Call it before the first advanceTo.
  void settleProps(Duration time);

  /// Lets the objects that are present fall from X_WO, each as one rigid body, together with the
  /// props, until all have come to rest. The props then start from there until restart(); the
  /// objects are where the next advanceTo puts them. Call it before the first advanceTo, or after
  /// restart(); requires PhysicsOptions::drops_objects.
  /// @param X_WO  of each object; nothing for one that is not in the world
  /// @return where the objects lie; nothing if something still moves after `time`
  [[nodiscard]] std::optional<std::vector<std::optional<Pose>>> drop(
      const std::vector<std::optional<Pose>>& X_WO, Duration time);

  /// The name of something that an object would overlap at X_WO by more than the contact tolerance:
  /// a static model, a prop where it is now, or one of the earlier objects where `X_WO_before` puts
  /// them. Of an articulated object, only the body that no driven link carries is checked.
  [[nodiscard]] std::optional<std::string> obstacleAt(
      int object, const Pose& X_WO, const std::vector<std::optional<Pose>>& X_WO_before) const;

  /// The name of something that a ball would touch, with everything where it is now: a static
  /// model, a prop, or an object or distractor that is present.
  [[nodiscard]] std::optional<std::string> obstacleNear(const Eigen::Vector3d& p_W,
                                                        double radius) const;

  /// The description as given, with what the simulation leaves out added to its notes.
  [[nodiscard]] const Description& description() const;

  /// All links, in an order that never changes: those of the description's models, then of the
  /// objects' variants, then of the distractors.
  [[nodiscard]] const std::vector<LinkInstance>& links() const;

  /// X_WL of each link, in the order of links(); valid after the first advanceTo.
  [[nodiscard]] const std::vector<Pose>& linkPoses() const;

  /// Increases whenever a prop or a distractor has moved: anything rendered before is out of date
  /// then. Movements of less than 0.01 mm do not count, and do not show in the poses either.
  [[nodiscard]] std::int64_t propRevision() const;

  /// The names of the props that have fallen by more than 5 m below both where they started and
  /// everything that stands still.
  [[nodiscard]] std::vector<std::string> fallenProps() const;

  /// Objects that now overlap each other or a static model by more than the tolerance, each pair
  /// once, sorted by names. Empty before the first advanceTo.
  [[nodiscard]] std::vector<Interpenetration> interpenetrations() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::world
