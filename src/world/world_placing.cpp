#include "world/world.h"
#include "world/world_impl.h"

/// What the world does for scenes that have nothing to do with one another.
namespace synthetic_dataset::world {
namespace {

const std::vector<const MovingCollisions*> kNoObjects;

/// @return whether all props have come to rest within `time`
bool runToRest(Physics& physics, Duration time, Duration step) {
  for (Duration passed{0}; passed < time && !physics.isAtRest(); passed += step) physics.step({});
  return physics.isAtRest();
}

/// Where the first `count` props are.
std::vector<Pose> firstPoses(const Physics& physics, std::size_t count) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i) poses.push_back(physics.propPose(i, Duration::zero()));
  return poses;
}

}  // namespace

std::vector<StartingProp> World::Impl::startingProps() const {
  std::vector<StartingProp> starting;
  for (std::size_t i = 0; i < props.size(); ++i) starting.push_back({&prop_models[i], starts[i]});
  return starting;
}

/// From now on, and shows them there.
void World::Impl::startPropsAt(const std::vector<Pose>& X_WM) {
  starts = X_WM;
  showPropsAt(X_WM);
}

std::vector<StandingBody> World::Impl::standingProps() const {
  std::vector<StandingBody> standing;
  for (std::size_t i = 0; i < props.size(); ++i) {
    const PropModel& model = prop_models[i];
    standing.push_back({&model.collisions, X_WP[i] * model.X_MB, model.name});
  }
  return standing;
}

StandingBody World::Impl::standingObject(std::size_t object, const Pose& X_WO) const {
  const std::size_t body = first_object_bodies[wornBy(object)];
  return {&object_collisions[body], X_WO, body_names[body]};
}

/// All that moves or is moved, as far as it is there: props and objects where they are now.
/// @param X_WM  of the distractors
std::vector<StandingBody> World::Impl::standingBodies(
    const std::vector<std::optional<Pose>>& X_WM) const {
  std::vector<StandingBody> standing = standingProps();
  const std::vector<bool> present_bodies = presentBodies();
  for (std::size_t i = 0; i < X_WB.size(); ++i) {
    if (!present_bodies[i]) continue;
    standing.push_back({&object_collisions[i], X_WB[i], body_names[i]});
  }
  for (std::size_t i = 0; i < X_WM.size(); ++i) {
    if (X_WM[i]) standing.push_back({&distractor_collisions[i], *X_WM[i], distractors[i].name});
  }
  return standing;
}

void World::restart() {
  impl_->start_time.reset();
  impl_->physics.reset();
  impl_->startPropsAt(impl_->home);
}

void World::settleProps(Duration time) {
  Impl& world = *impl_;
  Physics physics(world.description.gravity, world.options.step, world.fixed, kNoObjects,
                  world.startingProps());
  runToRest(physics, time, world.options.step);
  world.home = firstPoses(physics, world.props.size());
  world.startPropsAt(world.home);
}

std::optional<std::vector<Pose>> World::drop(const std::vector<Pose>& X_WO, Duration time) {
  Impl& world = *impl_;
  std::vector<StartingProp> falling = world.startingProps();
  for (std::size_t i = 0; i < X_WO.size(); ++i) {
    if (world.present[i]) falling.push_back({&world.falling_objects[world.wornBy(i)], X_WO[i]});
  }
  Physics physics(world.description.gravity, world.options.step, world.fixed, kNoObjects, falling);
  if (!runToRest(physics, time, world.options.step)) return std::nullopt;
  std::size_t next = world.props.size();
  std::vector<Pose> objects = X_WO;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (world.present[i]) objects[i] = physics.propPose(next++, Duration::zero());
  }
  world.startPropsAt(firstPoses(physics, world.props.size()));
  return objects;
}

std::optional<std::string> World::obstacleAt(int object, const Pose& X_WO,
                                             const std::vector<Pose>& X_WO_before) const {
  const Impl& world = *impl_;
  std::vector<StandingBody> others = world.standingProps();
  for (std::size_t i = 0; i < X_WO_before.size(); ++i) {
    others.push_back(world.standingObject(i, X_WO_before[i]));
  }
  return world.overlaps->obstacle(world.standingObject(static_cast<std::size_t>(object), X_WO),
                                  others, world.options.contact_tolerance);
}

std::vector<std::optional<Pose>> World::dropDistractors(
    const std::vector<std::optional<Pose>>& X_WM, Duration time) const {
  const Impl& world = *impl_;
  std::vector<const MovingCollisions*> standing;
  std::vector<Pose> X_WB;
  const std::vector<std::optional<Pose>> no_distractors(world.distractors.size());
  for (const StandingBody& body : world.standingBodies(no_distractors)) {
    standing.push_back(body.collisions);
    X_WB.push_back(body.X_WB);
  }
  std::vector<StartingProp> falling;
  for (std::size_t i = 0; i < X_WM.size(); ++i) {
    if (X_WM[i]) falling.push_back({&world.falling_distractors[i], *X_WM[i]});
  }
  const Duration step = world.options.step;
  Physics physics(world.description.gravity, step, world.fixed, standing, falling);
  physics.placeObjects(X_WB);
  for (Duration passed{0}; passed < time && !physics.isAtRest(); passed += step) {
    physics.step(X_WB);
  }
  std::vector<std::optional<Pose>> lying(X_WM.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < X_WM.size(); ++i) {
    if (!X_WM[i]) continue;
    if (physics.isAtRest(next)) lying[i] = physics.propPose(next, Duration::zero());
    ++next;
  }
  return lying;
}

void World::placeDistractors(const std::vector<std::optional<Pose>>& X_WM) {
  Impl& world = *impl_;
  for (std::size_t i = 0; i < world.distractors.size(); ++i) {
    const std::size_t first = world.first_distractor_links[i];
    if (X_WM[i]) world.show(world.distractors[i], first, *X_WM[i]);
    for (std::size_t k = 0; k < world.distractors[i].links.size(); ++k) {
      world.present_links[first + k] = X_WM[i].has_value();
    }
    if (world.options.labels_distractors) {
      world.present[world.first_variants.size() + i] = X_WM[i].has_value();
    }
  }
  world.X_WD = X_WM;
  ++world.prop_revision;
}

const std::vector<std::optional<Pose>>& World::distractorPoses() const { return impl_->X_WD; }

std::optional<std::string> World::obstacleOfDistractor(
    std::size_t distractor, const Pose& X_WM,
    const std::vector<std::optional<Pose>>& X_WM_before) const {
  const Impl& world = *impl_;
  const StandingBody body{&world.distractor_collisions[distractor], X_WM,
                          world.distractors[distractor].name};
  return world.overlaps->obstacle(body, world.standingBodies(X_WM_before),
                                  world.options.contact_tolerance);
}

std::optional<std::string> World::obstacleNear(const Eigen::Vector3d& p_W, double radius) const {
  return impl_->overlaps->obstacle(p_W, radius, impl_->standingBodies(impl_->X_WD));
}

}  // namespace synthetic_dataset::world
