#include "world/world.h"

#include <utility>

#include "synthetic_dataset/errors.h"
#include "world/world_impl.h"

namespace synthetic_dataset::world {
namespace {

/// So deep that nothing meets it.
const Pose& nowhere() {
  constexpr double kDepth = 1e5;  // [m]
  static const Pose X_WO = makePose({0, 0, -kDepth}, Eigen::Quaterniond::Identity());
  return X_WO;
}

constexpr Duration kShortestStep = std::chrono::microseconds(1);

std::string text(Stamp time) { return std::to_string(time.count()) + " ns"; }

PhysicsOptions checked(const PhysicsOptions& options) {
  if (options.step < kShortestStep) {
    throw Error("the simulation's step is " + text(options.step) + "; it has to be at least " +
                text(kShortestStep));
  }
  if (!(options.contact_tolerance >= 0.0)) {
    throw Error("the contact tolerance is " + std::to_string(options.contact_tolerance) +
                " m; it has to be 0 or more");
  }
  return options;
}

/// Runs `make` and keeps what it complains about.
template <class Make>
void collectErrors(std::vector<std::string>& errors, const Make& make) {
  try {
    make();
  } catch (const ErrorList& list) {
    errors.insert(errors.end(), list.messages().begin(), list.messages().end());
  }
}

std::vector<const MovingCollisions*> pointersTo(const std::vector<MovingCollisions>& collisions) {
  std::vector<const MovingCollisions*> pointers;
  for (const MovingCollisions& each : collisions) pointers.push_back(&each);
  return pointers;
}

bool samePoses(const std::vector<Pose>& a, const std::vector<Pose>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].matrix() != b[i].matrix()) return false;
  }
  return true;
}

}  // namespace

World::Impl::Impl(Description description_in, std::vector<MovingObject> objects_in,
                  const PhysicsOptions& options_in, std::vector<Model> distractors_in)
    : description(std::move(description_in)),
      objects(std::move(objects_in)),
      options(checked(options_in)),
      distractors(std::move(distractors_in)) {
  std::vector<std::string> errors;
  for (const Model& model : description.models) {
    const bool is_prop = !model.is_static && canMove(model);
    if (is_prop) {
      addProp(model, errors);
    } else {
      addFixed(model, errors);
    }
  }
  for (const MovingObject& object : objects) {
    addObject(object, errors);
    if (!options.drops_objects) continue;
    if (object.model.links.empty()) {
      falling_objects.emplace_back();  // there is nothing of it to fall
    } else {
      addFalling(object.model, "object", falling_objects, errors);
    }
  }
  for (const Model& model : distractors) {
    addDistractor(model, errors);
    if (options.drops_distractors) addFalling(model, "distractor", falling_distractors, errors);
  }
  if (!description.gravity.allFinite()) errors.emplace_back("the world's gravity is not finite");
  if (!errors.empty()) throw ErrorList(std::move(errors));

  overlaps = std::make_unique<OverlapFinder>(fixed, object_collisions, body_names);
  home = starts = X_WP;
  worn.assign(first_variants.size(), 0);
  present.assign(first_variants.size(), true);
  if (options.labels_distractors) present.resize(present.size() + distractors.size(), false);
  X_WD.assign(distractors.size(), std::nullopt);
  for (const LinkInstance& link : links) present_links.push_back(link.role != Role::kDistractor);
  updatePresentLinks();
}

void World::Impl::addLinks(const Model& model, Role role, int object, std::size_t variant) {
  for (const Link& link : model.links) {
    links.push_back({&link, role, object, model.name, variant});
    X_WL.push_back(model.X_WM * link.X_ML);
  }
}

void World::Impl::addFixed(const Model& model, std::vector<std::string>& errors) {
  addLinks(model, Role::kStatic, -1);
  if (!model.is_static) {
    description.notes.push_back("model '" + model.name +
                                "': it is not static, but has no collision that could hold it: it "
                                "stays where it is");
  }
  collectErrors(errors, [&] {
    for (FixedCollision& collision : fixedCollisions(model)) fixed.push_back(std::move(collision));
  });
}

void World::Impl::addProp(const Model& model, std::vector<std::string>& errors) {
  props.push_back({&model, links.size()});
  addLinks(model, Role::kProp, -1);
  X_WP.push_back(model.X_WM);
  collectErrors(errors, [&] {
    prop_models.push_back(makeProp(model));
    const auto& notes = prop_models.back().collisions.notes;
    description.notes.insert(description.notes.end(), notes.begin(), notes.end());
  });
}

void World::Impl::addObject(const MovingObject& object, std::vector<std::string>& errors) {
  const std::size_t place = object_of.size();
  if (!object.is_variant) first_variants.push_back(place);
  object_of.push_back(first_variants.size() - 1);
  first_object_links.push_back(links.size());
  first_object_bodies.push_back(object_collisions.size());
  addLinks(object.model, Role::kObject, static_cast<int>(object_of.back()),
           place - first_variants.back());
  collectErrors(errors, [&] {
    object_bodies.emplace_back(object);
    for (const Model& body : object_bodies.back().models(object.model)) {
      object_collisions.push_back(movingCollisions(body, Pose::Identity()));
      body_names.push_back(object.model.name);
      body_objects.push_back(place);
      const auto& notes = object_collisions.back().notes;
      description.notes.insert(description.notes.end(), notes.begin(), notes.end());
    }
  });
}

void World::Impl::addFalling(const Model& model, const std::string& what,
                             std::vector<PropModel>& falling, std::vector<std::string>& errors) {
  if (!canMove(model)) {
    errors.push_back(what + " '" + model.name +
                     "': it cannot be dropped, as its model has no collision");
    return;
  }
  collectErrors(errors, [&] { falling.push_back(makeProp(model)); });
}

void World::Impl::addDistractor(const Model& model, std::vector<std::string>& errors) {
  first_distractor_links.push_back(links.size());
  const auto number = static_cast<int>(first_variants.size() + first_distractor_links.size() - 1);
  addLinks(model, Role::kDistractor, options.labels_distractors ? number : -1);
  collectErrors(errors, [&] {
    distractor_collisions.push_back(movingCollisions(model, Pose::Identity()));
    const auto& notes = distractor_collisions.back().notes;
    description.notes.insert(description.notes.end(), notes.begin(), notes.end());
  });
}

std::vector<Pose> World::Impl::bodyPosesOf(std::size_t moving_object, Stamp time,
                                           const ObjectMotion& motion) const {
  const MovingObject& object = objects[moving_object];
  const ObjectPose pose = motion(static_cast<int>(moving_object), time);
  if (pose.X_WL.size() != object.driven_links.size()) {
    throw Error("object '" + object.model.name +
                "': " + std::to_string(object.driven_links.size()) + " links are driven, but " +
                std::to_string(pose.X_WL.size()) + " poses given");
  }
  std::vector<Pose> poses = ObjectBodies::poses(pose);
  for (const Pose& X_WB_one : poses) {
    if (X_WB_one.matrix().allFinite()) continue;
    throw Error("object '" + object.model.name + "': its pose at " + text(time) + " is not finite");
  }
  return poses;
}

std::vector<Pose> World::Impl::bodyPoses(Stamp time, const ObjectMotion& motion) const {
  std::vector<Pose> all;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::vector<Pose> poses = bodyPosesOf(i, time, motion);
    all.insert(all.end(), poses.begin(), poses.end());
  }
  return all;
}

/// Where bodies push and are pushed against: those that no object wears are out of the way, and
/// nobody is asked where they would be.
std::vector<Pose> World::Impl::tangiblePoses(Stamp time, const ObjectMotion& motion) const {
  std::vector<Pose> all;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (isWorn(i)) {
      const std::vector<Pose> poses = bodyPosesOf(i, time, motion);
      all.insert(all.end(), poses.begin(), poses.end());
    } else {
      all.insert(all.end(), objects[i].driven_links.size() + 1, nowhere());
    }
  }
  return all;
}

/// @return a place in objects
std::size_t World::Impl::wornBy(std::size_t object) const {
  return first_variants[object] + worn[object];
}

bool World::Impl::isWorn(std::size_t moving_object) const {
  return wornBy(object_of[moving_object]) == moving_object;
}

std::vector<bool> World::Impl::presentBodies() const {
  std::vector<bool> bodies;
  for (const std::size_t moving_object : body_objects) {
    bodies.push_back(present[object_of[moving_object]] && isWorn(moving_object));
  }
  return bodies;
}

/// Those of objects; distractors are there when they are placed.
void World::Impl::updatePresentLinks() {
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i].role != Role::kObject) continue;
    const auto object = static_cast<std::size_t>(links[i].object);
    present_links[i] = present[object] && worn[object] == links[i].variant;
  }
}

void World::Impl::start(Stamp time, const ObjectMotion& motion) {
  X_WB = bodyPoses(time, motion);
  start_time = time;
  steps_done = 0;
  if (props.empty()) return;
  physics = std::make_unique<Physics>(description.gravity, options.step, fixed,
                                      pointersTo(object_collisions), startingProps());
  std::vector<Pose> tangible = X_WB;
  for (std::size_t i = 0; i < tangible.size(); ++i) {
    if (!isWorn(body_objects[i])) tangible[i] = nowhere();
  }
  physics->placeObjects(tangible);
}

void World::Impl::simulateUntil(Stamp time, const ObjectMotion& motion) {
  if (!physics) return;
  const std::int64_t steps = (time - *start_time) / options.step;
  for (; steps_done < steps; ++steps_done) {
    physics->step(tangiblePoses(*start_time + (steps_done + 1) * options.step, motion));
  }
}

void World::Impl::show(const Model& model, std::size_t first_link, const Pose& X_WM) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    X_WL[first_link + i] = X_WM * model.links[i].X_ML;
  }
}

void World::Impl::showProps(Stamp time) {
  const Duration since = time - *start_time - steps_done * options.step;
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < props.size(); ++i) poses.push_back(physics->propPose(i, since));
  showPropsAt(std::move(poses));
}

void World::Impl::showPropsAt(std::vector<Pose> poses) {
  if (samePoses(poses, X_WP)) return;
  X_WP = std::move(poses);
  for (std::size_t i = 0; i < props.size(); ++i) {
    show(*props[i].model, props[i].first_link, X_WP[i]);
  }
  ++prop_revision;
}

void World::Impl::showObjects() {
  auto first_body = X_WB.begin();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const auto body_count = static_cast<std::ptrdiff_t>(objects[i].driven_links.size()) + 1;
    const std::vector<Pose> bodies(first_body, first_body + body_count);
    first_body += body_count;
    for (std::size_t link = 0; link < objects[i].model.links.size(); ++link) {
      X_WL[first_object_links[i] + link] = object_bodies[i].linkPose(link, bodies);
    }
  }
}

World::World(Description description, std::vector<MovingObject> objects,
             const PhysicsOptions& options, std::vector<Model> distractors)
    : impl_(std::make_unique<Impl>(std::move(description), std::move(objects), options,
                                   std::move(distractors))) {}

World::~World() = default;

void World::advanceTo(Stamp time, const ObjectMotion& motion) {
  Impl& world = *impl_;
  if (!world.start_time) {
    world.start(time, motion);
  } else if (time < world.now) {
    throw Error("the world cannot go back in time, to " + text(time) + " from " + text(world.now) +
                "; scenes have to be made in ascending order");
  } else {
    world.simulateUntil(time, motion);
    world.X_WB = world.bodyPoses(time, motion);
  }
  world.now = time;
  world.showProps(time);
  world.showObjects();
}

const Description& World::description() const { return impl_->description; }

const std::vector<LinkInstance>& World::links() const { return impl_->links; }

void World::setPresent(const std::vector<bool>& present) {
  std::copy(present.begin(), present.end(), impl_->present.begin());
  impl_->updatePresentLinks();
}

const std::vector<bool>& World::present() const { return impl_->present; }

void World::wear(const std::vector<std::size_t>& variants) {
  impl_->worn = variants;
  impl_->updatePresentLinks();
}

const std::vector<std::size_t>& World::worn() const { return impl_->worn; }

const std::vector<bool>& World::presentLinks() const { return impl_->present_links; }

const std::vector<Pose>& World::linkPoses() const { return impl_->X_WL; }

std::int64_t World::propRevision() const { return impl_->prop_revision; }

std::vector<Interpenetration> World::interpenetrations() const {
  if (!impl_->start_time) return {};
  return impl_->overlaps->find(impl_->X_WB, impl_->presentBodies(),
                               impl_->options.contact_tolerance);
}

}  // namespace synthetic_dataset::world
