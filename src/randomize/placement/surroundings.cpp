#include "randomize/placement/surroundings.h"

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::randomize {
namespace {

std::vector<std::size_t> linksOfSurroundings(const world::World& world) {
  std::vector<std::size_t> links;
  for (std::size_t i = 0; i < world.links().size(); ++i) {
    const world::LinkInstance& link = world.links()[i];
    const bool is_of_world = link.role == world::Role::kStatic || link.role == world::Role::kProp;
    if (is_of_world && link.object < 0) links.push_back(i);
  }
  return links;
}

template <class Each>
std::vector<Each> chosen(const std::vector<Each>& all, const std::vector<std::size_t>& indices) {
  std::vector<Each> result;
  for (const std::size_t index : indices) result.push_back(all[index]);
  return result;
}

}  // namespace

Surroundings::Surroundings(const world::World& world)
    : world_(world),
      links_(linksOfSurroundings(world)),
      prop_revision_(world.propRevision()),
      rays_(chosen(world.links(), links_), chosen(world.linkPoses(), links_)) {}

std::optional<world::RayHit> Surroundings::cast(const Eigen::Vector3d& p_G,
                                                const Eigen::Vector3d& direction_G, double range) {
  if (prop_revision_ != world_.propRevision()) {
    rays_.setLinkPoses(chosen(world_.linkPoses(), links_));
    prop_revision_ = world_.propRevision();
  }
  return rays_.cast(p_G, direction_G, range);
}

}  // namespace synthetic_dataset::randomize
