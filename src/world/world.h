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
  kStatic,      ///< stands where its file puts it
  kProp,        ///< moved by physics
  kObject,      ///< follows TF, and is labelled
  kDistractor,  ///< put somewhere now and then
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

/// Two things that are inside one another.
struct Interpenetration {
  std::string first;   ///< an object's name
  std::string second;  ///< an object's or a static model's name
  double depth = 0.0;  ///< [m], > 0
};

/// The world in motion (Bullet): objects are put where the recording says, static models stand,
/// props fall, settle and are pushed. The same calls give the same poses, bit for bit, and so does
/// the same time reached in other strides.
///
/// Models that are neither objects nor static are props, each one rigid body: its links hold
/// together as the file places them. An object is one kinematic body, or, where TF drives its
/// links, several, which never count as inside one another. It may have several models, its
/// variants, one of which is active at a time; only that one is seen and touched. An object of the
/// world's own is labelled, and in all else a static model or a prop. Meshes of props
/// and objects collide as their convex hulls, those of static models as their triangles. A prop
/// without any collision that could hold it (Gazebo would let it fall for ever) stands still and
/// counts as static; a prop that falls off the world stops after 10 km.
class World {
 public:
  /// Where a variant and its driven links are at a time; nothing while they are nowhere in the
  /// world, and push nothing. Variants are counted through all objects:
  /// those of the first object, then those of the second. Called for active variants at every step
  /// of the simulation, so it has to answer at any time between two scenes; for the others at the
  /// times of advanceTo alone.
  using ObjectPoseAt = std::function<std::optional<ObjectPose>(int variant, Stamp time)>;

  /// @param description  models that are neither objects nor static are props
  /// @param objects  in the order of `robot_list`; their models' poses are ignored
  /// @param distractors  absent until they are placed; nothing is pushed by them
  /// @throws ErrorList with every collision shape or mass that cannot be simulated, and its model
  World(Description description, std::vector<MovingObject> objects, const PhysicsOptions& options,
        std::vector<Model> distractors = {});
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Puts the world at `time`. The first call sets the clock: props start there, at rest. Later
  /// ones simulate the whole steps that lie in between, the objects moving along; for what is left
  /// of a step, a moving prop is shown a bit further along its velocity. Without props, they may go
  /// back.
  /// @throws Error if there are props and `time` is earlier than the last one, if an object's pose
  ///     is not finite or has not one pose a driven link, or if the simulation breaks down (naming
  ///     the prop); the world is of no further use then
  void advanceTo(Stamp time, const ObjectPoseAt& motion);

  /// Shows the world as it stood at `time`, when another one that moved alike had been advanced
  /// there; nothing is simulated. A world that was shown so is not advanced any more.
  /// @param X_WM  of the props, as propPoses
  /// @param X_WO  of all objects' variants, as ObjectPoseAt counts them
  /// @throws Error as advanceTo where a pose is missing or not finite
  void showAt(Stamp time, const std::vector<Pose>& X_WM,
              const std::vector<std::optional<ObjectPose>>& X_WO);

  /// X_WM of each prop, in their order, as it is shown.
  [[nodiscard]] std::vector<Pose> propPoses() const;

  /// Which objects are present from now on; at first, all. One that is not has no pixels, overlaps
  /// nothing and does not fall; it pushes props all the same.
  /// @param present  of each object
  void setPresent(const std::vector<bool>& present);

  /// @param object  index of an object or labelled distractor
  [[nodiscard]] bool isPresent(std::size_t object) const;

  /// Which of its variants is the active one of each object from now on; at first, that of index 0.
  /// @param variants  of each object, in range
  void setVariants(const std::vector<std::size_t>& variants);

  /// The active variant of an object; 0 for a labelled distractor, which has no other.
  [[nodiscard]] std::size_t variant(std::size_t object) const;

  /// Lets distractors fall from X_WM, each as one piece, among all that is present now, which
  /// stands still meanwhile. Only where the options say so.
  /// @param X_WM  of those that fall
  /// @return where those lie that have come to rest before `time` is up; nothing for all others
  [[nodiscard]] std::vector<std::optional<Pose>> dropDistractors(
      const std::vector<std::optional<Pose>>& X_WM, Duration time) const;

  /// Puts the distractors somewhere until they are placed anew: X_WM of each that is present.
  void placeDistractors(const std::vector<std::optional<Pose>>& X_WM);

  /// Where the distractors are: X_WM of each that is present.
  [[nodiscard]] std::vector<std::optional<Pose>> distractorPoses() const;

  /// X_WM of an object that is one of the world's own models, as it is shown; else nothing.
  [[nodiscard]] std::optional<Pose> poseOfOwn(std::size_t object) const;

  /// What a distractor would be inside of at X_WM: a static model, a prop, an object that is
  /// present, as they stand now, or a distractor before it, where `X_WM_before` puts it.
  [[nodiscard]] std::optional<std::string> obstacleOfDistractor(
      std::size_t distractor, const Pose& X_WM,
      const std::vector<std::optional<Pose>>& X_WM_before) const;

  /// Which links are seen now: those of active variants and of distractors, as far as they are
  /// present, and those of static models and props.
  [[nodiscard]] const std::vector<bool>& presentLinks() const;

  /// Puts everything back to where it started, and the clock too: the next advanceTo is a first
  /// one.
  void restart();

  /// Lets the props fall and come to rest without the objects, at most for `time`; from now on they
  /// start there. Call it before the first advanceTo.
  void settleProps(Duration time);

  /// Lets the objects that are present fall from X_WO, each as one piece, together with the props,
  /// until all have come to rest. The props start there until restart(); the objects are where the
  /// next advanceTo puts them. Call it before the first advanceTo, or after restart(), and only
  /// where the options say so.
  /// @param X_WO  of each object; nothing for one that is nowhere
  /// @return where the objects lie; nothing where something still moves after `time`
  [[nodiscard]] std::optional<std::vector<std::optional<Pose>>> drop(
      const std::vector<std::optional<Pose>>& X_WO, Duration time);

  /// What an object would be inside of at X_WO, by more than the contact tolerance: the name of a
  /// static model, of a prop where it stands now, or of one of the objects before it, where
  /// `X_WO_before` puts them. Its links are where its model has them.
  [[nodiscard]] std::optional<std::string> obstacleAt(
      int object, const Pose& X_WO, const std::vector<std::optional<Pose>>& X_WO_before) const;

  /// What a ball would touch, as everything stands now: the name of a static model, a prop, an
  /// object or distractor that is present.
  [[nodiscard]] std::optional<std::string> obstacleNear(const Eigen::Vector3d& p_W,
                                                        double radius) const;

  /// The description as given, and in its notes what the simulation leaves out.
  [[nodiscard]] const Description& description() const;

  /// All links, in an order that never changes: those of the description's models, of the objects'
  /// variants, of the distractors.
  [[nodiscard]] const std::vector<LinkInstance>& links() const;

  /// X_WL of each link, in the order of links(); valid after the first advanceTo.
  [[nodiscard]] const std::vector<Pose>& linkPoses() const;

  /// Counts up whenever a prop or a distractor has moved: what was drawn of the world before is out
  /// of date. Movements of less than 0.01 mm do not count, and do not show in the poses either.
  [[nodiscard]] std::int64_t propRevision() const;

  /// The names of the props that have fallen past everything that stands still, by more than 5 m,
  /// and where nothing stands still, from where they started.
  [[nodiscard]] std::vector<std::string> fallenProps() const;

  /// Objects that now overlap each other or a static model by more than the tolerance, each pair
  /// once, sorted by names. Nothing before the first advanceTo.
  [[nodiscard]] std::vector<Interpenetration> interpenetrations() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::world
