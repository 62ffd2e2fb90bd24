#include "world/mesh/closed_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace synthetic_dataset::world {
namespace {

using Index = std::uint32_t;

/// For each vertex the first one at its place.
std::vector<Index> placesOf(const std::vector<Eigen::Vector3f>& positions) {
  constexpr double kSteps = 1U << 18U;  // in the mesh's size
  float size = 0.0F;
  for (const Eigen::Vector3f& position : positions) {
    size = std::max(size, position.cwiseAbs().maxCoeff());
  }
  const double steps = size > 0.0F ? kSteps / static_cast<double>(size) : 0.0;
  std::vector<std::pair<std::array<std::int32_t, 3>, Index>> sorted;
  sorted.reserve(positions.size());
  for (const Eigen::Vector3f& position : positions) {
    const Eigen::Vector3i cell =
        (position.cast<double>() * steps).array().round().cast<std::int32_t>();
    sorted.push_back({{cell.x(), cell.y(), cell.z()}, static_cast<Index>(sorted.size())});
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<Index> places(positions.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool is_new = i == 0 || sorted[i].first != sorted[i - 1].first;
    places[sorted[i].second] = is_new ? sorted[i].second : places[sorted[i - 1].second];
  }
  return places;
}

/// Whether along each edge as many triangles go one way as the other.
bool edgesMeet(const std::vector<Index>& corners) {
  std::vector<std::pair<std::uint64_t, int>> edges;  // the vertices, and which way
  edges.reserve(corners.size());
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    for (std::size_t side = 0; side < 3; ++side) {
      const std::uint64_t from = corners[i + side];
      const std::uint64_t to = corners[i + (side + 1) % 3];
      if (from < to) edges.emplace_back(from << 32U | to, 1);
      if (from > to) edges.emplace_back(to << 32U | from, -1);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i > 0 && edges[i].first != edges[i - 1].first && sum != 0) return false;
    sum += edges[i].second;
  }
  return sum == 0;
}

/// Which vertices hang together.
class Pieces {
 public:
  explicit Pieces(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), Index{0});
  }

  /// The vertex that stands for a piece.
  [[nodiscard]] Index of(Index vertex) {
    while (parents_[vertex] != vertex) {
      parents_[vertex] = parents_[parents_[vertex]];
      vertex = parents_[vertex];
    }
    return vertex;
  }

  void join(Index a, Index b) { parents_[of(a)] = of(b); }

 private:
  std::vector<Index> parents_;
};

/// Whether triangles face outwards, piece by piece.
bool enclosesVolume(const std::vector<Index>& corners,
                    const std::vector<Eigen::Vector3f>& positions) {
  Pieces pieces(positions.size());
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    pieces.join(corners[i], corners[i + 1]);
    pieces.join(corners[i], corners[i + 2]);
  }
  std::vector<double> volumes(positions.size(), 0.0);  // times six
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Index piece = pieces.of(corners[i]);
    const auto corner = [&](std::size_t which) {
      return Eigen::Vector3d((positions[corners[i + which]] - positions[piece]).cast<double>());
    };
    volumes[piece] += corner(0).dot(corner(1).cross(corner(2)));
  }
  return std::all_of(corners.begin(), corners.end(),
                     [&](Index corner) { return volumes[pieces.of(corner)] > 0.0; });
}

}  // namespace

bool isSurfaceOfBodies(const Mesh& mesh) {
  const bool are_finite =
      std::all_of(mesh.positions.begin(), mesh.positions.end(),
                  [](const Eigen::Vector3f& position) { return position.allFinite(); });
  if (!are_finite) return false;
  const std::vector<Index> places = placesOf(mesh.positions);
  std::vector<Index> corners;
  corners.reserve(mesh.indices.size());
  for (const Index index : mesh.indices) corners.push_back(places[index]);
  return !corners.empty() && edgesMeet(corners) && enclosesVolume(corners, mesh.positions);
}

}  // namespace synthetic_dataset::world
