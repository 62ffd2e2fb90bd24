#include "world/shape/gazebo_wrapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

namespace synthetic_dataset::world {
namespace {

/// Turns from one axis towards another, 0 to 1.
float turns(float along, float across) {
  const auto turn = static_cast<float>(std::atan2(across, along) / (2.0 * M_PI));
  return turn < 0.0F ? turn + 1.0F : turn;
}

using Column = PicturePoint::Column;
using Corners = std::array<PicturePoint, 3>;

/// The corners of a triangle on one sheet of the picture: each within half a turn of its middle.
void joinTurns(Corners& corners, const PicturePoint& middle) {
  float sum = 0.0F;
  int count = 0;
  for (PicturePoint& corner : corners) {
    if (corner.column != Column::kTurns) continue;
    corner.u += std::round(middle.u - corner.u);
    sum += corner.u;
    ++count;
  }
  for (PicturePoint& corner : corners) {
    if (corner.column == Column::kAny) corner.u = sum / static_cast<float>(std::max(count, 1));
  }
}

}  // namespace

PicturePoint aroundY(const Eigen::Vector3f& position, const Eigen::Vector3f& /*normal*/) {
  const float across = std::hypot(position.x(), position.z());
  const float v = static_cast<float>(std::atan2(across, position.y()) / M_PI);
  constexpr float kPole = 1e-5F;  // of the radius
  const bool is_pole = across < kPole * position.norm();
  return {turns(position.z(), position.x()), v, is_pole ? Column::kAny : Column::kTurns};
}

PicturePoint aroundCylinder(const Eigen::Vector3f& position, const Eigen::Vector3f& normal) {
  if (position.head<2>().isZero()) return {0.0F, 0.0F, Column::kFixed};
  const bool is_below = normal.z() < 0.0F || (normal.z() == 0.0F && position.z() < 0.0F);
  return {turns(position.y(), position.x()), is_below ? 0.0F : 1.0F};
}

void wrapAsGazebo(Mesh& mesh, PicturePoint (*wrapping)(const Eigen::Vector3f& position,
                                                       const Eigen::Vector3f& normal)) {
  Mesh wrapped;
  std::map<std::tuple<std::uint32_t, float, float>, std::uint32_t> vertices;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t* const triangle = &mesh.indices[i];
    Corners corners{};
    Eigen::Vector3f position(0, 0, 0);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      corners[k] = wrapping(mesh.positions[triangle[k]], mesh.normals[triangle[k]]);
      position += mesh.positions[triangle[k]] / 3.0F;
    }
    joinTurns(corners, wrapping(position, mesh.normals[triangle[0]]));
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto [vertex, is_new] =
          vertices.try_emplace(std::make_tuple(triangle[k], corners[k].u, corners[k].v),
                               static_cast<std::uint32_t>(wrapped.positions.size()));
      if (is_new) {
        wrapped.positions.push_back(mesh.positions[triangle[k]]);
        wrapped.normals.push_back(mesh.normals[triangle[k]]);
        wrapped.texture_coordinates.emplace_back(corners[k].u, corners[k].v);
      }
      wrapped.indices.push_back(vertex->second);
    }
  }
  mesh = std::move(wrapped);
}

}  // namespace synthetic_dataset::world
