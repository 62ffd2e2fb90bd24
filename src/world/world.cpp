#include "world/world.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/diagnostics.h"
#include "synthetic_dataset/errors.h"
#include "world/material/default_paint.h"
#include "world/world_impl.h"

namespace synthetic_dataset::world {
namespace {

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

/// X_WB of each body of a variant; nothing for all of them if the variant is not in the world.
/// @param index  index of the variant, numbered as for ObjectPoseAt
std::vector<std::optional<Pose>> bodyPoses(const MovingModel& moving, int index, Stamp time,
                                           const World::ObjectPoseAt& motion) {
  const std::optional<ObjectPose> pose = motion(index, time);
  if (!pose) return std::vector<std::optional<Pose>>(moving.driven_links.size() + 1);
  if (pose->X_WL.size() != moving.driven_links.size()) {
    throw Error("object '" + moving.model.name +
                "': " + std::to_string(moving.driven_links.size()) + " links are driven, but " +
                std::to_string(pose->X_WL.size()) + " poses given");
  }
  const std::vector<Pose> poses = ObjectBodies::poses(*pose);
  for (const Pose& X_WB : poses) {
    if (X_WB.matrix().allFinite()) continue;
    throw Error("object '" + moving.model.name + "': its pose at " + text(time) + " is not finite");
  }
  return {poses.begin(), poses.end()};
}

/// @throws ErrorList
PropModel makeFalling(const Model& model, const std::string& what) {
  if (canMove(model)) return makeProp(model);
  throw ErrorList(
      {what + " '" + model.name + "': it cannot be dropped, as its model has no collision"});
}

}  // namespace

World::Impl::Impl(Description description_in, std::vector<MovingObject> objects_in,
                  const PhysicsOptions& options_in, std::vector<Model> distractors_in)
    : description(std::move(description_in)), options(checked(options_in)) {
  base::Diagnostics errors;
  for (Model& model : description.models) paintDefaults(description.simulator, model);
  for (MovingObject& object : objects_in) {
    for (MovingModel& variant : object.variants) {
      paintDefaults(description.simulator, variant.model);
    }
  }
  for (Model& model : distractors_in) paintDefaults(description.simulator, model);
  objects.resize(objects_in.size());
  for (std::size_t i = 0; i < objects_in.size(); ++i) {
    const std::string& own = objects_in[i].of_world;
    if (!own.empty()) own_objects.emplace(own, static_cast<int>(i));
  }
  for (const Model& model : description.models) {
    const bool is_prop = !model.is_static && canMove(model);
    if (is_prop) {
      addProp(model, errors);
    } else {
      addFixed(model, errors);
    }
  }
  for (std::size_t i = 0; i < objects_in.size(); ++i) {
    addObject(std::move(objects_in[i]), static_cast<int>(i), errors);
  }
  for (Model& model : distractors_in) addDistractor(std::move(model), errors);
  if (!description.gravity.allFinite()) errors.error("", "the world's gravity is not finite");
  errors.throwIfAny();

  overlaps = std::make_unique<OverlapFinder>(fixed);
  for (const LinkInstance& link : links) present_links.push_back(link.role != Role::kDistractor);
  updatePresentLinks();
}

/// @param instance  what all links of the model have in common
/// @return the index of the first one
std::size_t World::Impl::addLinks(const Model& model, LinkInstance instance) {
  const std::size_t first = links.size();
  instance.model = model.name;
  for (const Link& link : model.links) {
    instance.link = &link;
    links.push_back(instance);
    X_WL.push_back(model.X_WM * link.X_ML);
  }
  return first;
}

/// A body's collisions in its own frame; what is left out goes to the description's notes.
MovingCollisions World::Impl::collisionsOf(const Model& body) {
  MovingCollisions collisions = movingCollisions(body, Pose::Identity());
  description.notes.insert(description.notes.end(), collisions.notes.begin(),
                           collisions.notes.end());
  return collisions;
}

/// The index of the object that a model of the description is; -1 if it is not an object.
int World::Impl::objectOf(const Model& model) {
  const auto own = own_objects.find(model.name);
  if (own == own_objects.end()) return -1;
  Object& object = objects[static_cast<std::size_t>(own->second)];
  if (object.of_world != nullptr) return -1;  // two models of the same name
  object.of_world = &model;
  return own->second;
}

void World::Impl::addFixed(const Model& model, base::Diagnostics& errors) {
  static_cast<void>(addLinks(model, {nullptr, Role::kStatic, objectOf(model)}));
  if (!model.is_static) {
    description.notes.push_back("model '" + model.name +
                                "': it is not static, but has no collision that could hold it: it "
                                "stays where it is");
  }
  errors.attempt([&] {
    for (FixedCollision& collision : fixedCollisions(model)) fixed.push_back(std::move(collision));
  });
}

void World::Impl::addProp(const Model& model, base::Diagnostics& errors) {
  const std::size_t first_link = addLinks(model, {nullptr, Role::kProp, objectOf(model)});
  errors.attempt([&] {
    props.push_back({&model, first_link, makeProp(model), model.X_WM, model.X_WM, model.X_WM});
    const auto& notes = props.back().body.collisions.notes;
    description.notes.insert(description.notes.end(), notes.begin(), notes.end());
  });
}

void World::Impl::addObject(MovingObject object, int index, base::Diagnostics& errors) {
  Object& added = objects[static_cast<std::size_t>(index)];
  if (!object.of_world.empty() && added.of_world == nullptr) {
    errors.error("", "the world has no model '" + object.of_world + "'");
  }
  for (std::size_t i = 0; i < object.variants.size(); ++i) {
    const Model& model = object.variants[i].model;
    const std::size_t first_link = addLinks(model, {nullptr, Role::kObject, index, "", i});
    std::optional<PropModel> falling;
    if (options.drops_objects && !model.links.empty()) {
      errors.attempt([&] { falling = makeFalling(model, "object"); });
    }
    errors.attempt([&] {
      const ObjectBodies parts(object.variants[i]);
      std::vector<Body> bodies;
      for (const Model& body : parts.models(model)) bodies.push_back({collisionsOf(body), {}});
      added.variants.push_back({std::move(object.variants[i]), first_link, parts, std::move(bodies),
                                std::move(falling)});
    });
  }
}

void World::Impl::addDistractor(Model model, base::Diagnostics& errors) {
  const auto index = static_cast<int>(objects.size() + distractors.size());
  Distractor& added = distractors.emplace_back();
  added.model = std::move(model);
  added.first_link =
      addLinks(added.model, {nullptr, Role::kDistractor, options.labels_distractors ? index : -1});
  errors.attempt([&] { added.collisions = collisionsOf(added.model); });
  if (!options.drops_distractors) return;
  errors.attempt([&] { added.falling = makeFalling(added.model, "distractor"); });
}

void World::Impl::moveObjects(Stamp time, const ObjectPoseAt& motion) {
  int index = 0;
  bool has_changed = false;
  for (Object& object : objects) {
    bool has_pose = false;
    for (Variant& variant : object.variants) {
      const std::vector<std::optional<Pose>> X_WB =
          bodyPoses(variant.moving, index++, time, motion);
      for (std::size_t i = 0; i < X_WB.size(); ++i) variant.bodies[i].X_WB = X_WB[i];
      has_pose = has_pose || X_WB.front();
    }
    has_changed = has_changed || has_pose != object.has_pose;
    object.has_pose = has_pose;
  }
  if (has_changed) updatePresentLinks();
}

/// The poses of all bodies. Those of inactive variants have none: they do not collide, and the
/// motion is not evaluated for them.
std::vector<std::optional<Pose>> World::Impl::activePoses(Stamp time,
                                                          const ObjectPoseAt& motion) const {
  std::vector<std::optional<Pose>> all;
  int index = 0;
  for (const Object& object : objects) {
    for (const Variant& variant : object.variants) {
      if (&variant == &object.variants[object.active]) {
        const std::vector<std::optional<Pose>> X_WB =
            bodyPoses(variant.moving, index, time, motion);
        all.insert(all.end(), X_WB.begin(), X_WB.end());
      } else {
        all.insert(all.end(), variant.bodies.size(), std::nullopt);
      }
      ++index;
    }
  }
  return all;
}

void World::Impl::setPresentLinks(const Model& model, std::size_t first_link, bool present) {
  std::fill_n(present_links.begin() + static_cast<std::ptrdiff_t>(first_link), model.links.size(),
              present);
}

/// Updates the links of objects; those of distractors follow from their placement.
void World::Impl::updatePresentLinks() {
  for (const Object& object : objects) {
    for (const Variant& variant : object.variants) {
      const bool is_active = &variant == &object.variants[object.active];
      setPresentLinks(variant.moving.model, variant.first_link,
                      object.is_present && object.has_pose && is_active);
    }
  }
}

void World::Impl::start(Stamp time, const ObjectPoseAt& motion) {
  moveObjects(time, motion);
  start_time = time;
  steps_done = 0;
  if (props.empty()) return;
  std::vector<const MovingCollisions*> collisions;
  std::vector<std::optional<Pose>> X_WB;
  for (const Object& object : objects) {
    for (const Variant& variant : object.variants) {
      const bool is_active = &variant == &object.variants[object.active];
      for (const Body& body : variant.bodies) {
        collisions.push_back(&body.collisions);
        X_WB.push_back(is_active ? body.X_WB : std::nullopt);
      }
    }
  }
  physics = std::make_unique<Physics>(description.gravity, options.step, fixed, collisions,
                                      startingProps());
  physics->placeObjects(X_WB);
}

void World::Impl::simulateUntil(Stamp time, const ObjectPoseAt& motion) {
  if (!physics) return;
  const std::int64_t steps = (time - *start_time) / options.step;
  for (; steps_done < steps; ++steps_done) {
    physics->step(activePoses(*start_time + (steps_done + 1) * options.step, motion));
  }
}

void World::Impl::show(const Model& model, std::size_t first_link, const Pose& X_WM) {
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    X_WL[first_link + i] = X_WM * model.links[i].X_ML;
  }
}

void World::Impl::showProps(Stamp time) {
  const Duration since = time - *start_time - steps_done * options.step;
  std::vector<Pose> X_WM;
  for (std::size_t i = 0; i < props.size(); ++i) X_WM.push_back(physics->propPose(i, since));
  showPropsAt(X_WM);
}

void World::Impl::showPropsAt(const std::vector<Pose>& X_WM) {
  bool has_moved = false;
  for (std::size_t i = 0; i < props.size(); ++i) {
    Prop& prop = props[i];
    if (prop.X_WM.matrix() == X_WM[i].matrix()) continue;
    prop.X_WM = X_WM[i];
    show(*prop.model, prop.first_link, prop.X_WM);
    has_moved = true;
  }
  if (has_moved) ++prop_revision;
}

void World::Impl::showObjects() {
  for (const Object& object : objects) {
    for (const Variant& variant : object.variants) {
      for (std::size_t i = 0; i < variant.moving.model.links.size(); ++i) {
        const Body& body = variant.bodies[variant.parts.bodyOf(i)];
        if (body.X_WB) X_WL[variant.first_link + i] = variant.parts.linkPose(i, *body.X_WB);
      }
    }
  }
}

World::World(Description description, std::vector<MovingObject> objects,
             const PhysicsOptions& options, std::vector<Model> distractors)
    : impl_(std::make_unique<Impl>(std::move(description), std::move(objects), options,
                                   std::move(distractors))) {}

World::~World() = default;

void World::advanceTo(Stamp time, const ObjectPoseAt& motion) {
  Impl& world = *impl_;
  if (!world.start_time) {
    world.start(time, motion);
  } else if (time < world.now && world.physics) {
    throw Error("the world cannot go back in time, to " + text(time) + " from " + text(world.now) +
                "; its physics only moves forward");
  } else {
    world.simulateUntil(time, motion);
    world.moveObjects(time, motion);
  }
  world.now = time;
  world.showProps(time);
  world.showObjects();
}

void World::showAt(Stamp time, const std::vector<Pose>& X_WM,
                   const std::vector<std::optional<ObjectPose>>& X_WO) {
  Impl& world = *impl_;
  if (X_WM.size() != world.props.size()) {
    throw Error(std::to_string(world.props.size()) + " props are to be shown, but " +
                std::to_string(X_WM.size()) + " poses given");
  }
  world.moveObjects(time,
                    [&](int variant, Stamp) { return X_WO.at(static_cast<std::size_t>(variant)); });
  world.start_time = world.start_time.value_or(time);
  world.now = time;
  world.showPropsAt(X_WM);
  world.showObjects();
}

std::vector<Pose> World::propPoses() const {
  std::vector<Pose> X_WM;
  for (const Impl::Prop& prop : impl_->props) X_WM.push_back(prop.X_WM);
  return X_WM;
}

const Description& World::description() const { return impl_->description; }

const std::vector<LinkInstance>& World::links() const { return impl_->links; }

void World::setPresent(const std::vector<bool>& present) {
  for (std::size_t i = 0; i < present.size(); ++i) impl_->objects[i].is_present = present[i];
  impl_->updatePresentLinks();
}

bool World::isPresent(std::size_t object) const {
  const std::vector<Impl::Object>& objects = impl_->objects;
  if (object < objects.size()) return objects[object].is_present;
  return impl_->distractors[object - objects.size()].X_WM.has_value();
}

void World::setVariants(const std::vector<std::size_t>& variants) {
  for (std::size_t i = 0; i < variants.size(); ++i) impl_->objects[i].active = variants[i];
  impl_->updatePresentLinks();
}

std::size_t World::variant(std::size_t object) const {
  return object < impl_->objects.size() ? impl_->objects[object].active : 0;
}

const std::vector<bool>& World::presentLinks() const { return impl_->present_links; }

const std::vector<Pose>& World::linkPoses() const { return impl_->X_WL; }

std::optional<Pose> World::worldModelPose(std::size_t object) const {
  const Model* model = impl_->objects[object].of_world;
  if (model == nullptr) return std::nullopt;
  for (const Impl::Prop& prop : impl_->props) {
    if (prop.model == model) return prop.X_WM;
  }
  return model->X_WM;
}

std::int64_t World::propRevision() const { return impl_->prop_revision; }

std::vector<std::string> World::fallenProps() const {
  constexpr double kFallen = 5.0;  // [m]
  const Eigen::Vector3d down = impl_->description.gravity.normalized();
  const std::optional<double> deepest = deepestPoint(impl_->fixed, down);
  std::vector<std::string> names;
  for (const Impl::Prop& prop : impl_->props) {
    const double start = down.dot(prop.model->X_WM.translation());
    const double end = std::max(start, deepest.value_or(start));
    if (down.dot(prop.X_WM.translation()) > end + kFallen) names.push_back(prop.model->name);
  }
  return names;
}

std::vector<Interpenetration> World::interpenetrations() const {
  if (!impl_->start_time) return {};
  return impl_->overlaps->find(impl_->standingObjects(), impl_->options.contact_tolerance);
}

}  // namespace synthetic_dataset::world
