#include "world/physics/object_bodies.h"

#include <optional>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {

ObjectBodies::ObjectBodies(const MovingModel& moving)
    : body_count_(moving.driven_links.size() + 1), body_of_(moving.model.links.size(), 0) {
  const std::vector<Link>& links = moving.model.links;
  std::vector<std::size_t> driven_as(links.size(), 0);  // 0: is not driven
  for (std::size_t i = 0; i < moving.driven_links.size(); ++i) {
    const std::size_t link = moving.driven_links[i];
    if (link >= links.size() || driven_as[link] != 0) {
      throw ErrorList({"model '" + moving.model.name + "': link " + std::to_string(link) +
                       " cannot be driven: there are " + std::to_string(links.size()) +
                       " links, and each can be driven once"});
    }
    driven_as[link] = i + 1;
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    std::optional<std::size_t> carrier = i;
    while (carrier && driven_as[*carrier] == 0) carrier = links[*carrier].parent;
    if (carrier) body_of_[i] = driven_as[*carrier];
    X_BL_.push_back(carrier ? links[*carrier].X_ML.inverse() * links[i].X_ML : links[i].X_ML);
    if (carrier == i) X_BL_.back() = Pose::Identity();
  }
}

std::vector<Model> ObjectBodies::models(const Model& model) const {
  Model empty = model;
  empty.links.clear();
  std::vector<Model> bodies(body_count_, empty);
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    Link link = model.links[i];
    link.X_ML = X_BL_[i];
    link.parent.reset();
    bodies[body_of_[i]].links.push_back(std::move(link));
  }
  return bodies;
}

std::vector<Pose> ObjectBodies::poses(const ObjectPose& pose) {
  std::vector<Pose> X_WB{pose.X_WO};
  X_WB.insert(X_WB.end(), pose.X_WL.begin(), pose.X_WL.end());
  return X_WB;
}

}  // namespace synthetic_dataset::world
