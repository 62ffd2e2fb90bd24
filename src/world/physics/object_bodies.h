#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "world/description.h"

namespace synthetic_dataset::world {

/// A model that is moved from outside: as a whole, and, link by link, where it is articulated.
struct MovingModel {
  MovingModel(Model model_in, std::vector<std::size_t> driven_links_in = {})
      : model(std::move(model_in)), driven_links(std::move(driven_links_in)) {}

  Model model;                            ///< its frame M is the object's frame O
  std::vector<std::size_t> driven_links;  ///< indices in the model's links, each once
};

/// An object: one model, or several, its variants, of which it has one at a time; or a model of the
/// world's own, which stands there or is moved by physics as any other.
struct MovingObject {
  MovingObject(Model model, std::vector<std::size_t> driven_links = {}) {
    variants.emplace_back(std::move(model), std::move(driven_links));
  }
  explicit MovingObject(std::vector<MovingModel> variants_in) : variants(std::move(variants_in)) {}

  /// @param model  the name of one of the description's
  static MovingObject ofWorld(std::string model) {
    MovingObject object(std::vector<MovingModel>{});
    object.of_world = std::move(model);
    return object;
  }

  std::vector<MovingModel> variants;  ///< at least one, unless it is of the world
  std::string of_world;               ///< the name of its model there; else empty
};

/// Where an object is.
struct ObjectPose {
  ObjectPose(const Pose& X_WO_in, std::vector<Pose> X_WL_in = {})
      : X_WO(X_WO_in), X_WL(std::move(X_WL_in)) {}

  Pose X_WO;
  std::vector<Pose> X_WL;  ///< of the driven links, in their order
};

/// An object taken apart into what moves as one piece: first all that no driven link carries, in
/// the object's frame, then each driven link with what hangs on it by way of parents, in that
/// link's frame.
class ObjectBodies {
 public:
  /// @throws ErrorList for driven links that the model does not have
  explicit ObjectBodies(const MovingModel& moving);

  /// One a body: its links, their poses X_ML in the body's frame. All bear the object's name.
  [[nodiscard]] std::vector<Model> models(const Model& model) const;

  /// X_WB of each body.
  [[nodiscard]] static std::vector<Pose> poses(const ObjectPose& pose);

  /// The body that a link belongs to.
  [[nodiscard]] std::size_t bodyOf(std::size_t link) const { return body_of_[link]; }

  /// X_WL of a link. @param X_WB  of its body
  [[nodiscard]] Pose linkPose(std::size_t link, const Pose& X_WB) const {
    return X_WB * X_BL_[link];
  }

 private:
  std::size_t body_count_;
  std::vector<std::size_t> body_of_;  ///< of each link
  std::vector<Pose> X_BL_;            ///< of each link
};

}  // namespace synthetic_dataset::world
