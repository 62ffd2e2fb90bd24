#include <optional>
#include <utility>

#include "world/world.h"
#include "world/world_impl.h"

/// The parts of World for scenes that are independent of one another.
namespace synthetic_dataset::world {
namespace {

const std::vector<const MovingCollisions*> kNoObjects;

/// @return whether all props have come to rest within `time`
bool runToRest(Physics& physics, Duration time, Duration step) {
  for (Duration passed{0}; passed < time && !physics.isAtRest(); passed += step) physics.step({});
  return physics.isAtRest();
}

/// The poses of the first `count` props.
std::vector<Pose> firstPoses(const Physics& physics, std::size_t count) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i) poses.push_back(physics.propPose(i, Duration::zero()));
  return poses;
}

}  // namespace

std::vector<StartingProp> World::Impl::startingProps() const {
  std::vector<StartingProp> starting;
  for (const Prop& prop : props) starting.push_back({&prop.body, prop.start});
  return starting;
}

/// Makes the props start from X_WM from now on, and shows them there.
void World::Impl::startPropsAt(const std::vector<Pose>& X_WM) {
  for (std::size_t i = 0; i < props.size(); ++i) props[i].start = X_WM[i];
  showPropsAt(X_WM);
}

std::vector<StandingBody> World::Impl::standingProps() const {
  std::vector<StandingBody> standing;
  for (const Prop& prop : props) {
    standing.push_back({&prop.body.collisions, prop.X_WM * prop.body.X_MB, prop.body.name});
  }
  return standing;
}

/// The present objects at their poses.
std::vector<StandingBody> World::Impl::standingObjects() const {
  std::vector<StandingBody> standing;
  for (const Object& object : objects) {
    if (!object.is_present || object.variants.empty()) continue;  // the world's own have no bodies
    const Variant& variant = object.variants[object.active];
    for (const Body& body : variant.bodies) {
      if (body.X_WB) standing.push_back({&body.collisions, *body.X_WB, variant.moving.model.name});
    }
  }
  return standing;
}

StandingBody World::Impl::standingObject(std::size_t object, const Pose& X_WO) const {
  const Variant& variant = objects[object].variants[objects[object].active];
  return {&variant.bodies.front().collisions, X_WO, variant.moving.model.name};
}

/// Everything that moves or is moved, if it is present: props and objects where they are now.
/// @param X_WM  of the distractors
std::vector<StandingBody> World::Impl::standingBodies(
    const std::vector<std::optional<Pose>>& X_WM) const {
  std::vector<StandingBody> standing = standingProps();
  for (StandingBody& body : standingObjects()) standing.push_back(std::move(body));
  for (std::size_t i = 0; i < X_WM.size(); ++i) {
    if (!X_WM[i]) continue;
    standing.push_back({&distractors[i].collisions, *X_WM[i], distractors[i].model.name});
  }
  return standing;
}

void World::restart() {
  impl_->start_time.reset();
  impl_->physics.reset();
  std::vector<Pose> X_WM;
  for (const Impl::Prop& prop : impl_->props) X_WM.push_back(prop.home);
  impl_->startPropsAt(X_WM);
}

void World::settleProps(Duration time) {
  Impl& world = *impl_;
  Physics physics(world.description.gravity, world.options.step, world.fixed, kNoObjects,
                  world.startingProps());
  runToRest(physics, time, world.options.step);
  const std::vector<Pose> X_WM = firstPoses(physics, world.props.size());
  for (std::size_t i = 0; i < X_WM.size(); ++i) world.props[i].home = X_WM[i];
  world.startPropsAt(X_WM);
}

std::optional<std::vector<std::optional<Pose>>> World::drop(
    const std::vector<std::optional<Pose>>& X_WO, Duration time) {
  Impl& world = *impl_;
  std::vector<StartingProp> falling = world.startingProps();
  std::vector<std::size_t> dropped;  // objects, in the order in which they follow the props
  for (std::size_t i = 0; i < X_WO.size(); ++i) {
    const Impl::Object& object = world.objects[i];
    if (!X_WO[i] || !object.is_present || object.variants.empty()) continue;
    const std::optional<PropModel>& model = object.variants[object.active].falling;
    if (!model) continue;
    falling.push_back({&*model, *X_WO[i]});
    dropped.push_back(i);
  }
  Physics physics(world.description.gravity, world.options.step, world.fixed, kNoObjects, falling);
  if (!runToRest(physics, time, world.options.step)) return std::nullopt;
  std::size_t next = world.props.size();
  std::vector<std::optional<Pose>> objects = X_WO;
  for (const std::size_t i : dropped) objects[i] = physics.propPose(next++, Duration::zero());
  world.startPropsAt(firstPoses(physics, world.props.size()));
  return objects;
}

std::optional<std::string> World::obstacleAt(
    int object, const Pose& X_WO, const std::vector<std::optional<Pose>>& X_WO_before) const {
  const Impl& world = *impl_;
  std::vector<StandingBody> others = world.standingProps();
  for (std::size_t i = 0; i < X_WO_before.size(); ++i) {
    const bool is_body = X_WO_before[i] && !world.objects[i].variants.empty();
    if (is_body) others.push_back(world.standingObject(i, *X_WO_before[i]));
  }
  return world.overlaps->obstacle(world.standingObject(static_cast<std::size_t>(object), X_WO),
                                  others, world.options.contact_tolerance);
}

std::vector<std::optional<Pose>> World::dropDistractors(
    const std::vector<std::optional<Pose>>& X_WM, Duration time) const {
  const Impl& world = *impl_;
  std::vector<const MovingCollisions*> standing;
  std::vector<std::optional<Pose>> X_WB;
  for (const StandingBody& body : world.standingBodies({})) {
    standing.push_back(body.collisions);
    X_WB.push_back(body.X_WB);
  }
  std::vector<StartingProp> falling;
  for (std::size_t i = 0; i < X_WM.size(); ++i) {
    if (X_WM[i]) falling.push_back({&*world.distractors[i].falling, *X_WM[i]});
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
    Impl::Distractor& distractor = world.distractors[i];
    distractor.X_WM = X_WM[i];
    world.setPresentLinks(distractor.model, distractor.first_link, X_WM[i].has_value());
    if (X_WM[i]) world.show(distractor.model, distractor.first_link, *X_WM[i]);
  }
  ++world.prop_revision;
}

std::vector<std::optional<Pose>> World::distractorPoses() const {
  std::vector<std::optional<Pose>> X_WM;
  for (const Impl::Distractor& distractor : impl_->distractors) X_WM.push_back(distractor.X_WM);
  return X_WM;
}

std::optional<std::string> World::obstacleOfDistractor(
    std::size_t distractor, const Pose& X_WM,
    const std::vector<std::optional<Pose>>& X_WM_before) const {
  const Impl::Distractor& own = impl_->distractors[distractor];
  return impl_->overlaps->obstacle({&own.collisions, X_WM, own.model.name},
                                   impl_->standingBodies(X_WM_before),
                                   impl_->options.contact_tolerance);
}

std::optional<std::string> World::obstacleNear(const Eigen::Vector3d& p_W, double radius) const {
  return impl_->overlaps->obstacle(p_W, radius, impl_->standingBodies(distractorPoses()));
}

}  // namespace synthetic_dataset::world
