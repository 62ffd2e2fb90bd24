#include "world/mesh/closed_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace synthetic_dataset::world {
namespace {

using Index = std::uint32_t;

/// For each vertex, the index of the first one at the same place.
std::vector<Index> placesOf(const std::vector<Eigen::Vector3f>& positions) {
  constexpr double kSteps = 1U << 23U;  // over the mesh's size: the resolution of single precision
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

using TriangleIndices = std::array<Index, 3>;

/// The triangles with three different corners.
std::vector<TriangleIndices> trianglesOf(const Mesh& mesh, const std::vector<Index>& places) {
  std::vector<TriangleIndices> triangles;
  triangles.reserve(mesh.indices.size() / 3);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const TriangleIndices corners = {places[mesh.indices[i]], places[mesh.indices[i + 1]],
                                     places[mesh.indices[i + 2]]};
    const bool is_line =
        corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
    if (!is_line) triangles.push_back(corners);
  }
  return triangles;
}

/// A triangle's side.
struct Edge {
  std::uint64_t ends = 0;   ///< its vertices, the smaller first
  bool is_forward = false;  ///< whether the triangle goes from the smaller to the larger
  Index triangle = 0;
};

std::vector<Edge> edgesOf(const std::vector<TriangleIndices>& triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t side = 0; side < 3; ++side) {
      const std::uint64_t from = triangles[i].at(side);
      const std::uint64_t to = triangles[i].at((side + 1) % 3);
      edges.push_back(
          {std::min(from, to) << 32U | std::max(from, to), from < to, static_cast<Index>(i)});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.ends, a.triangle) < std::tie(b.ends, b.triangle);
  });
  return edges;
}

/// The connected pieces of a set of triangles (union-find).
class Pieces {
 public:
  explicit Pieces(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), Index{0});
  }

  /// The triangle that represents a piece.
  [[nodiscard]] Index of(Index triangle) {
    while (parents_[triangle] != triangle) {
      parents_[triangle] = parents_[parents_[triangle]];
      triangle = parents_[triangle];
    }
    return triangle;
  }

  void join(Index a, Index b) { parents_[of(a)] = of(b); }

 private:
  std::vector<Index> parents_;
};

/// The pieces, if each edge is shared by exactly two triangles that wind consistently; else
/// nothing.
std::optional<Pieces> closedPieces(const std::vector<TriangleIndices>& triangles) {
  const std::vector<Edge> edges = edgesOf(triangles);
  Pieces pieces(triangles.size());
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    const bool are_two = i + 1 < edges.size() && edges[i].ends == edges[i + 1].ends &&
                         (i + 2 == edges.size() || edges[i + 2].ends != edges[i].ends);
    if (!are_two || edges[i].is_forward == edges[i + 1].is_forward) return std::nullopt;
    pieces.join(edges[i].triangle, edges[i + 1].triangle);
  }
  return pieces;
}

/// Whether the triangles of each piece face outwards, so that it encloses a volume above 0.
bool encloseVolume(const std::vector<TriangleIndices>& triangles, Pieces& pieces,
                   const std::vector<Eigen::Vector3f>& positions) {
  std::vector<double> volumes(triangles.size(), 0.0);  // times six
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto corner = [&](std::size_t which) {
      const Eigen::Vector3f& origin = positions[triangles.front()[0]];
      return Eigen::Vector3d((positions[triangles[i].at(which)] - origin).cast<double>());
    };
    volumes[pieces.of(static_cast<Index>(i))] += corner(0).dot(corner(1).cross(corner(2)));
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!(volumes[pieces.of(static_cast<Index>(i))] > 0.0)) return false;
  }
  return true;
}

}  // namespace

bool isSurfaceOfBodies(const Mesh& mesh) {
  const bool are_finite =
      std::all_of(mesh.positions.begin(), mesh.positions.end(),
                  [](const Eigen::Vector3f& position) { return position.allFinite(); });
  if (!are_finite) return false;
  const std::vector<TriangleIndices> triangles = trianglesOf(mesh, placesOf(mesh.positions));
  std::optional<Pieces> pieces = closedPieces(triangles);
  return pieces && !triangles.empty() && encloseVolume(triangles, *pieces, mesh.positions);
}

}  // namespace synthetic_dataset::world
