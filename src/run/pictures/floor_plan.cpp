#include "run/pictures/floor_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace synthetic_dataset::run {
namespace {

const cv::Scalar kGroundInk(222, 226, 228);
const cv::Scalar kStandingInk(168, 172, 178);

using Triangle = std::array<Eigen::Vector3d, 3>;

enum class Layer { kGround, kStanding, kAbove };

Layer layerOf(const Triangle& triangle, double ground) {
  constexpr double kStep = 0.15;    // [m]; anything lower is the ground
  constexpr double kCeiling = 2.2;  // [m]
  const auto [low, high] = std::minmax({triangle[0].z(), triangle[1].z(), triangle[2].z()});
  if (low > ground + kCeiling) return Layer::kAbove;
  return high < ground + kStep ? Layer::kGround : Layer::kStanding;
}

/// Calls `see` with each triangle of static models and props.
template <class See>
void forTriangles(const std::vector<world::LinkInstance>& links, const std::vector<Pose>& X_WL,
                  const See& see) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    const world::Role role = links[i].role;
    if (role != world::Role::kStatic && role != world::Role::kProp) continue;
    for (const world::Visual& visual : links[i].link->visuals) {
      const Pose X_WV = X_WL[i] * visual.X_LV;
      for (const world::Surface& surface : visual.surfaces) {
        const world::Mesh& mesh = *surface.mesh;
        for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
          Triangle triangle;
          for (std::size_t c = 0; c < 3; ++c) {
            triangle[c] =
                X_WV * Eigen::Vector3d(mesh.positions[mesh.indices[k + c]].cast<double>());
          }
          see(triangle);
        }
      }
    }
  }
}

}  // namespace

void drawFloorPlan(MapPaper& paper, const std::vector<world::LinkInstance>& links,
                   const std::vector<Pose>& X_WL, double ground) {
  const auto draw = [&](Layer layer, const cv::Scalar& ink) {
    forTriangles(links, X_WL, [&](const Triangle& triangle) {
      if (layerOf(triangle, ground) != layer) return;
      paper.fill({triangle[0], triangle[1], triangle[2]}, ink);
    });
  };
  draw(Layer::kGround, kGroundInk);
  draw(Layer::kStanding, kStandingInk);
}

double floorHeight(const std::vector<world::LinkInstance>& links, const std::vector<Pose>& X_WL) {
  constexpr double kStep = 0.05;     // [m]
  constexpr double kUpright = 0.95;  // a horizontal triangle's normal along z is larger
  std::map<std::int64_t, double> areas;
  forTriangles(links, X_WL, [&](const Triangle& triangle) {
    const Eigen::Vector3d normal =
        (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);  // length: twice its area
    if (!(std::abs(normal.z()) > kUpright * normal.norm())) return;
    areas[std::llround(triangle[0].z() / kStep)] += 0.5 * normal.norm();
  });
  double largest = 0.0;
  for (const auto& [step, area] : areas) largest = std::max(largest, area);
  for (const auto& [step, area] : areas) {
    if (area >= 0.5 * largest) return kStep * static_cast<double>(step);
  }
  return 0.0;
}

Eigen::AlignedBox2d floorExtent(const std::vector<world::LinkInstance>& links,
                                const std::vector<Pose>& X_WL, double ground) {
  Eigen::AlignedBox2d standing;
  Eigen::AlignedBox2d lying;
  forTriangles(links, X_WL, [&](const Triangle& triangle) {
    const Layer layer = layerOf(triangle, ground);
    if (layer == Layer::kAbove) return;
    Eigen::AlignedBox2d& extent = layer == Layer::kGround ? lying : standing;
    for (const Eigen::Vector3d& corner : triangle) extent.extend(Eigen::Vector2d(corner.head<2>()));
  });
  return standing.isEmpty() ? lying : standing;
}

}  // namespace synthetic_dataset::run
