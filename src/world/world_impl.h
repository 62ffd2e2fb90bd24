#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/physics/collision_models.h"
#include "world/physics/overlap_finder.h"
#include "world/physics/physics.h"
#include "world/world.h"

namespace synthetic_dataset::world {

struct World::Impl {
  Impl(Description description_in, std::vector<MovingObject> objects_in,
       const PhysicsOptions& options_in, std::vector<Model> distractors_in);

  void addFixed(const Model& model, std::vector<std::string>& errors);
  void addProp(const Model& model, std::vector<std::string>& errors);
  void addObject(const MovingObject& object, std::vector<std::string>& errors);
  static void addFalling(const Model& model, const std::string& what,
                         std::vector<PropModel>& falling, std::vector<std::string>& errors);
  void addDistractor(const Model& model, std::vector<std::string>& errors);
  void addLinks(const Model& model, Role role, int object, std::size_t variant = 0);

  [[nodiscard]] std::vector<StartingProp> startingProps() const;
  void startPropsAt(const std::vector<Pose>& X_WM);
  void start(Stamp time, const ObjectMotion& motion);
  void simulateUntil(Stamp time, const ObjectMotion& motion);
  void showProps(Stamp time);
  void showPropsAt(std::vector<Pose> poses);
  [[nodiscard]] std::vector<StandingBody> standingProps() const;
  [[nodiscard]] std::vector<StandingBody> standingBodies(
      const std::vector<std::optional<Pose>>& X_WM) const;
  [[nodiscard]] StandingBody standingObject(std::size_t object, const Pose& X_WO) const;
  void show(const Model& model, std::size_t first_link, const Pose& X_WM);
  void showObjects();
  [[nodiscard]] std::vector<Pose> bodyPoses(Stamp time, const ObjectMotion& motion) const;
  [[nodiscard]] std::vector<Pose> bodyPosesOf(std::size_t moving_object, Stamp time,
                                              const ObjectMotion& motion) const;
  [[nodiscard]] std::vector<Pose> tangiblePoses(Stamp time, const ObjectMotion& motion) const;
  [[nodiscard]] std::size_t wornBy(std::size_t object) const;
  [[nodiscard]] bool isWorn(std::size_t moving_object) const;
  [[nodiscard]] std::vector<bool> presentBodies() const;
  void updatePresentLinks();

  /// A model of the description that moves, and where its links stand in `links`.
  struct ShownProp {
    const Model* model;
    std::size_t first_link;
  };

  Description description;
  const std::vector<MovingObject> objects;  ///< each one followed by its variants
  const PhysicsOptions options;
  const std::vector<Model> distractors;

  std::vector<LinkInstance> links;
  std::vector<Pose> X_WL;                   ///< of links
  std::vector<std::size_t> first_variants;  ///< of each object that is no variant, in objects
  std::vector<std::size_t> object_of;       ///< of objects: the number without variants
  std::vector<std::size_t> worn;            ///< variants, of objects by that number
  std::vector<bool> present;        ///< of objects by that number, then of labelled distractors
  std::vector<bool> present_links;  ///< of links
  std::vector<ShownProp> props;
  std::vector<PropModel> prop_models;            ///< of props
  std::vector<Pose> home;                        ///< X_WP where props start unless dropped on
  std::vector<Pose> starts;                      ///< X_WP where props start now
  std::vector<std::size_t> first_object_links;   ///< of objects
  std::vector<std::size_t> first_object_bodies;  ///< of objects, in object_collisions
  std::vector<ObjectBodies> object_bodies;       ///< of objects
  std::vector<PropModel> falling_objects;        ///< the objects, where they are dropped
  std::vector<PropModel> falling_distractors;    ///< the distractors, where they are dropped

  std::vector<FixedCollision> fixed;
  std::vector<MovingCollisions> object_collisions;      ///< body by body, of all objects in turn
  std::vector<std::string> body_names;                  ///< of the objects that they belong to
  std::vector<std::size_t> body_objects;                ///< those, in objects
  std::vector<MovingCollisions> distractor_collisions;  ///< of distractors
  std::vector<std::size_t> first_distractor_links;      ///< of distractors
  std::unique_ptr<OverlapFinder> overlaps;
  std::unique_ptr<Physics> physics;  ///< none where there is no prop: nothing depends on the past,
                                     ///< and none before the start

  std::optional<Stamp> start_time;
  Stamp now{0};
  std::int64_t steps_done = 0;
  std::vector<Pose> X_WB;                 ///< of the objects' bodies, now
  std::vector<Pose> X_WP;                 ///< of props, as shown
  std::vector<std::optional<Pose>> X_WD;  ///< of distractors that are there
  std::int64_t prop_revision = 0;
};

}  // namespace synthetic_dataset::world
