#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "world/description.h"

namespace synthetic_dataset::world {

/// A model whose motion is given from outside: as a whole and, if it is articulated, link by link.
struct MovingModel {
  MovingModel(Model model_in, std::vector<std::size_t> driven_links_in = {})
      : model(std::move(model_in)), driven_links(std::move(driven_links_in)) {}

  Model model;                            ///< its frame M is the object's frame O
  std::vector<std::size_t> driven_links;  ///< indices in the model's links, each once
};

/// An object: one or more models, its variants, of which it is one at a time; or one of the world's
/// own models, which is static or moved by physics like any other.
struct MovingObject {
  MovingObject(Model model, std::vector<std::size_t> driven_links = {}) {
    variants.emplace_back(std::move(model), std::move(driven_links));
  }
  explicit MovingObject(std::vector<MovingModel> variants_in) : variants(std::move(variants_in)) {}

  /// @param model  the name of a model of the description
  static MovingObject ofWorld(std::string model) {
    MovingObject object(std::vector<MovingModel>{});
    object.of_world = std::move(model);
    return object;
  }

  std::vector<MovingModel> variants;  ///< at least one, unless it is one of the world's own models
  std::string of_world;               ///< the name of that model; else empty
};

/// Where an object is.
struct ObjectPose {
  ObjectPose(const Pose& X_WO_in, std::vector<Pose> X_WL_in = {})
      : X_WO(X_WO_in), X_WL(std::move(X_WL_in)) {}

  Pose X_WO;
  std::vector<Pose> X_WL;  ///< of the driven links, in their order
};

/// An object divided into rigid bodies: first everything that no driven link carries, in the
/// object's frame; then each driven link with everything that hangs on it without being driven
/// itself, in that link's frame.
class ObjectBodies {
 public:
  /// @throws ErrorList for driven links that the model does not have
  explicit ObjectBodies(const MovingModel& moving);

  /// One model per body, with its links; their X_ML are poses in the body's frame. All have the
  /// object's name.
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
