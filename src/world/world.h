#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "synthetic_dataset/pose.h"
#include "world/description.h"
#include "world/physics/object_bodies.h"

namespace synthetic_dataset::world {

enum class Role {
  kStatic,  ///< stands where its file puts it
  kProp,    ///< moved by physics
  kObject,  ///< follows TF, and is labelled
};

/// One link of one model in the running world.
struct LinkInstance {
  const Link* link = nullptr;  ///< lives as long as the world
  Role role = Role::kStatic;
  int object = -1;         ///< index of the object (kObject), else -1
  std::string model = "";  ///< the name of its model
};

struct PhysicsOptions {
  Duration step = std::chrono::microseconds(4000);  ///< of the simulation, fixed; at least 1 us
  double contact_tolerance = 0.01;  ///< [m], >= 0: shallower overlaps are not reported
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
/// Models that are no object and not static are props, each one rigid body: its links hold together
/// as the file places them. An object is one kinematic body, or, where TF drives its links,
/// several, which never count as inside one another. Meshes of props and objects collide as their
/// convex hulls, those of static models as their triangles. A prop without any collision that could
/// hold it (Gazebo would let it fall for ever) stands still and counts as static; a prop that falls
/// off the world stops after 10 km.
class World {
 public:
  /// Where object `object` and its driven links are at a time. Called for every step of the
  /// simulation, so it has to answer at any time between two scenes.
  using ObjectMotion = std::function<ObjectPose(int object, Stamp time)>;

  /// @param description  models that are no object and not static are props
  /// @param objects  in the order of `robot_list`; their models' poses are ignored
  /// @throws ErrorList with every collision shape or mass that cannot be simulated, and its model
  World(Description description, std::vector<MovingObject> objects, const PhysicsOptions& options);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Puts the world at `time`. The first call sets the clock: props start there, at rest. Later
  /// ones simulate the whole steps that lie in between, the objects moving along; for what is left
  /// of a step, a moving prop is shown a bit further along its velocity.
  /// @throws Error if `time` is earlier than the last one, if an object's pose is not finite or
  ///     has not one pose a driven link, or if
  ///     the simulation breaks down (naming the prop); the world is of no further use then
  void advanceTo(Stamp time, const ObjectMotion& motion);

  /// The description as given, and in its notes what the simulation leaves out.
  [[nodiscard]] const Description& description() const;

  /// All links, in an order that never changes: the description's models, then the objects.
  [[nodiscard]] const std::vector<LinkInstance>& links() const;

  /// X_WL of each link, in the order of links(); valid after the first advanceTo.
  [[nodiscard]] const std::vector<Pose>& linkPoses() const;

  /// Counts up whenever a prop has moved: what was drawn of the world before is out of date.
  /// Movements of less than 0.01 mm do not count, and do not show in the poses either.
  [[nodiscard]] std::int64_t propRevision() const;

  /// Objects that now overlap each other or a static model by more than the tolerance, each pair
  /// once, sorted by names. Nothing before the first advanceTo.
  [[nodiscard]] std::vector<Interpenetration> interpenetrations() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::world
