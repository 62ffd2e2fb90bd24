#include "world/world.h"

#include <optional>
#include <utility>

#include "synthetic_dataset/errors.h"
#include "world/physics/collision_models.h"
#include "world/physics/overlap_finder.h"
#include "world/physics/physics.h"

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

/// Runs `make` and keeps what it complains about.
template <class Make>
void collectErrors(std::vector<std::string>& errors, const Make& make) {
  try {
    make();
  } catch (const ErrorList& list) {
    errors.insert(errors.end(), list.messages().begin(), list.messages().end());
  }
}

bool samePoses(const std::vector<Pose>& a, const std::vector<Pose>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].matrix() != b[i].matrix()) return false;
  }
  return true;
}

}  // namespace

struct World::Impl {
  Impl(Description description_in, std::vector<MovingObject> objects_in,
       const PhysicsOptions& options_in);

  void addFixed(const Model& model, std::vector<std::string>& errors);
  void addProp(const Model& model, std::vector<PropModel>& props, std::vector<std::string>& errors);
  void addObject(const MovingObject& object, std::vector<std::string>& errors);
  void addLinks(const Model& model, Role role, int object);

  void start(Stamp time, const ObjectMotion& motion);
  void simulateUntil(Stamp time, const ObjectMotion& motion);
  void showProps(Stamp time);
  void show(const Model& model, std::size_t first_link, const Pose& X_WM);
  void showObjects();
  [[nodiscard]] std::vector<Pose> bodyPoses(Stamp time, const ObjectMotion& motion) const;

  /// A model of the description that moves, and where its links stand in `links`.
  struct ShownProp {
    const Model* model;
    std::size_t first_link;
  };

  Description description;
  const std::vector<MovingObject> objects;
  const PhysicsOptions options;

  std::vector<LinkInstance> links;
  std::vector<Pose> X_WL;  ///< of links
  std::vector<ShownProp> props;
  std::vector<std::size_t> first_object_links;  ///< of objects
  std::vector<ObjectBodies> object_bodies;      ///< of objects

  std::vector<FixedCollision> fixed;
  std::vector<MovingCollisions> object_collisions;  ///< body by body, of all objects in turn
  std::vector<std::string> body_names;              ///< of the objects that they belong to
  std::unique_ptr<OverlapFinder> overlaps;
  std::unique_ptr<Physics> physics;  ///< none where there is no prop: nothing depends on the past

  std::optional<Stamp> start_time;
  Stamp now{0};
  std::int64_t steps_done = 0;
  std::vector<Pose> X_WB;  ///< of the objects' bodies, now
  std::vector<Pose> X_WP;  ///< of props, as shown
  std::int64_t prop_revision = 0;
};

World::Impl::Impl(Description description_in, std::vector<MovingObject> objects_in,
                  const PhysicsOptions& options_in)
    : description(std::move(description_in)),
      objects(std::move(objects_in)),
      options(checked(options_in)) {
  std::vector<std::string> errors;
  std::vector<PropModel> prop_models;
  for (const Model& model : description.models) {
    const bool is_prop = !model.is_static && canMove(model);
    if (is_prop) {
      addProp(model, prop_models, errors);
    } else {
      addFixed(model, errors);
    }
  }
  for (const MovingObject& object : objects) addObject(object, errors);
  if (!description.gravity.allFinite()) errors.emplace_back("the world's gravity is not finite");
  if (!errors.empty()) throw ErrorList(std::move(errors));

  overlaps = std::make_unique<OverlapFinder>(fixed, object_collisions, body_names);
  if (props.empty()) return;
  physics = std::make_unique<Physics>(description.gravity, options.step, fixed, object_collisions,
                                      std::move(prop_models));
}

void World::Impl::addLinks(const Model& model, Role role, int object) {
  for (const Link& link : model.links) {
    links.push_back({&link, role, object, model.name});
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

void World::Impl::addProp(const Model& model, std::vector<PropModel>& prop_models,
                          std::vector<std::string>& errors) {
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
  first_object_links.push_back(links.size());
  addLinks(object.model, Role::kObject, static_cast<int>(first_object_links.size()) - 1);
  collectErrors(errors, [&] {
    object_bodies.emplace_back(object);
    for (const Model& body : object_bodies.back().models(object.model)) {
      object_collisions.push_back(movingCollisions(body, Pose::Identity()));
      body_names.push_back(object.model.name);
      const auto& notes = object_collisions.back().notes;
      description.notes.insert(description.notes.end(), notes.begin(), notes.end());
    }
  });
}

std::vector<Pose> World::Impl::bodyPoses(Stamp time, const ObjectMotion& motion) const {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const ObjectPose pose = motion(static_cast<int>(i), time);
    if (pose.X_WL.size() != objects[i].driven_links.size()) {
      throw Error("object '" + objects[i].model.name +
                  "': " + std::to_string(objects[i].driven_links.size()) +
                  " links are driven, but " + std::to_string(pose.X_WL.size()) + " poses given");
    }
    for (const Pose& X_WB_one : ObjectBodies::poses(pose)) {
      if (!X_WB_one.matrix().allFinite()) {
        throw Error("object '" + objects[i].model.name + "': its pose at " + text(time) +
                    " is not finite");
      }
      poses.push_back(X_WB_one);
    }
  }
  return poses;
}

void World::Impl::start(Stamp time, const ObjectMotion& motion) {
  X_WB = bodyPoses(time, motion);
  if (physics) physics->placeObjects(X_WB);
  start_time = time;
}

void World::Impl::simulateUntil(Stamp time, const ObjectMotion& motion) {
  if (!physics) return;
  const std::int64_t steps = (time - *start_time) / options.step;
  for (; steps_done < steps; ++steps_done) {
    physics->step(bodyPoses(*start_time + (steps_done + 1) * options.step, motion));
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
             const PhysicsOptions& options)
    : impl_(std::make_unique<Impl>(std::move(description), std::move(objects), options)) {}

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

const std::vector<Pose>& World::linkPoses() const { return impl_->X_WL; }

std::int64_t World::propRevision() const { return impl_->prop_revision; }

std::vector<Interpenetration> World::interpenetrations() const {
  if (!impl_->start_time) return {};
  return impl_->overlaps->find(impl_->X_WB, impl_->options.contact_tolerance);
}

}  // namespace synthetic_dataset::world
