#include "run/check/named_rays.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

namespace synthetic_dataset::run {
namespace {

bool isAround(const world::LinkInstance& link) {
  const bool is_of_world = link.role == world::Role::kStatic || link.role == world::Role::kProp;
  return is_of_world && link.object < 0;
}

std::vector<world::LinkInstance> surroundingLinks(const world::World& world) {
  std::vector<world::LinkInstance> links;
  std::copy_if(world.links().begin(), world.links().end(), std::back_inserter(links), isAround);
  return links;
}

std::vector<Pose> surroundingPoses(const world::World& world) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < world.links().size(); ++i) {
    if (isAround(world.links()[i])) poses.push_back(world.linkPoses()[i]);
  }
  return poses;
}

}  // namespace

NamedRays::NamedRays(const world::World& world)
    : rays_(surroundingLinks(world), surroundingPoses(world)) {
  for (const world::LinkInstance& link : surroundingLinks(world)) models_.push_back(link.model);
}

std::optional<NamedHit> NamedRays::cast(const Eigen::Vector3d& p_G,
                                        const Eigen::Vector3d& direction_G, double range) const {
  const auto hit = rays_.cast(p_G, direction_G, range);
  if (!hit) return std::nullopt;
  return NamedHit{models_[hit->link], hit->distance};
}

std::set<std::size_t> NamedRays::crossedOddly(const Eigen::Vector3d& p_G,
                                              const Eigen::Vector3d& direction_G) const {
  constexpr double kFar = 1000.0;    // [m]
  constexpr double kPast = 1e-4;     // beyond the surface that was hit [m]
  constexpr int kMostSurfaces = 64;  // so many surfaces in a row do not enclose anything
  std::map<std::size_t, int> crossings;
  Eigen::Vector3d from_G = p_G;
  for (int i = 0; i < kMostSurfaces; ++i) {
    const auto hit = rays_.cast(from_G, direction_G, kFar);
    if (!hit) break;
    ++crossings[hit->link];
    from_G += (hit->distance + kPast) * direction_G.normalized();
  }
  std::set<std::size_t> odd;
  for (const auto& [link, count] : crossings) {
    if (count % 2 == 1) odd.insert(link);
  }
  return odd;
}

std::set<std::size_t> NamedRays::around(const Eigen::Vector3d& p_G) const {
  // Not along an axis, where the edges of boxes lie.
  static const std::array<Eigen::Vector3d, 3> kDirections = {Eigen::Vector3d(0.13, 0.21, 0.97),
                                                             Eigen::Vector3d(-0.94, 0.31, 0.17),
                                                             Eigen::Vector3d(0.27, -0.93, -0.24)};
  std::map<std::size_t, std::size_t> votes;
  for (const Eigen::Vector3d& direction : kDirections) {
    for (const std::size_t link : crossedOddly(p_G, direction)) ++votes[link];
  }
  std::set<std::size_t> inside;
  for (const auto& [link, count] : votes) {
    if (count == kDirections.size()) inside.insert(link);
  }
  return inside;
}

}  // namespace synthetic_dataset::run
