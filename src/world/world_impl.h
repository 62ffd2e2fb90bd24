#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "world/physics/collision_models.h"
#include "world/physics/overlap_finder.h"
#include "world/physics/physics.h"
#include "world/world.h"

namespace synthetic_dataset::world {

struct World::Impl {
  /// A model of the description that physics moves.
  struct Prop {
    const Model* model;
    std::size_t first_link;  ///< in `links`
    PropModel body;
    Pose home;   ///< X_WM where it starts unless objects were dropped on it
    Pose start;  ///< X_WM where it starts now
    Pose X_WM;   ///< as shown
  };

  /// A part of a variant that moves as one rigid body.
  struct Body {
    MovingCollisions collisions;
    std::optional<Pose> X_WB;  ///< current pose; nothing before the first start
  };

  struct Variant {
    MovingModel moving;
    std::size_t first_link;  ///< in `links`
    ObjectBodies parts;
    std::vector<Body> bodies;
    std::optional<PropModel> falling;  ///< if objects are dropped and the model has links
  };

  struct Object {
    std::vector<Variant> variants;    ///< empty for one of the world's own models
    const Model* of_world = nullptr;  ///< that model, static or a prop's
    std::size_t active = 0;           ///< index of the variant that is seen and touched
    bool is_present = true;
    bool has_pose = true;  ///< false while its pose is not known
  };

  struct Distractor {
    Model model;
    std::size_t first_link;  ///< in `links`
    MovingCollisions collisions;
    std::optional<PropModel> falling;  ///< if distractors are dropped
    std::optional<Pose> X_WM;          ///< nothing while it is absent
  };

  Impl(Description description_in, std::vector<MovingObject> objects_in,
       const PhysicsOptions& options_in, std::vector<Model> distractors_in);

  [[nodiscard]] int objectOf(const Model& model);
  void addFixed(const Model& model, base::Diagnostics& errors);
  void addProp(const Model& model, base::Diagnostics& errors);
  void addObject(MovingObject object, int index, base::Diagnostics& errors);
  void addDistractor(Model model, base::Diagnostics& errors);
  [[nodiscard]] std::size_t addLinks(const Model& model, LinkInstance instance);
  [[nodiscard]] MovingCollisions collisionsOf(const Model& body);

  [[nodiscard]] std::vector<StartingProp> startingProps() const;
  void startPropsAt(const std::vector<Pose>& X_WM);
  void start(Stamp time, const ObjectPoseAt& motion);
  void simulateUntil(Stamp time, const ObjectPoseAt& motion);
  void showProps(Stamp time);
  void showPropsAt(const std::vector<Pose>& X_WM);
  [[nodiscard]] std::vector<StandingBody> standingProps() const;
  [[nodiscard]] std::vector<StandingBody> standingObjects() const;
  [[nodiscard]] std::vector<StandingBody> standingBodies(
      const std::vector<std::optional<Pose>>& X_WM) const;
  [[nodiscard]] StandingBody standingObject(std::size_t object, const Pose& X_WO) const;
  void show(const Model& model, std::size_t first_link, const Pose& X_WM);
  void setPresentLinks(const Model& model, std::size_t first_link, bool present);
  void moveObjects(Stamp time, const ObjectPoseAt& motion);
  void showObjects();
  [[nodiscard]] std::vector<std::optional<Pose>> activePoses(Stamp time,
                                                             const ObjectPoseAt& motion) const;
  void updatePresentLinks();

  Description description;
  const PhysicsOptions options;

  std::vector<FixedCollision> fixed;
  std::vector<Prop> props;
  std::vector<Object> objects;
  std::map<std::string, int> own_objects;  ///< by the names of their models in the description
  std::vector<Distractor> distractors;

  std::vector<LinkInstance> links;
  std::vector<Pose> X_WL;           ///< of links
  std::vector<bool> present_links;  ///< of links

  std::unique_ptr<OverlapFinder> overlaps;
  std::unique_ptr<Physics> physics;  ///< null before the start, and without props: then
                                     ///< nothing depends on the past

  std::optional<Stamp> start_time;
  Stamp now{0};
  std::int64_t steps_done = 0;
  std::int64_t prop_revision = 0;
};

}  // namespace synthetic_dataset::world
