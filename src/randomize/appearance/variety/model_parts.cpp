#include "randomize/appearance/variety/model_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "randomize/appearance/variety/joined_sets.h"

namespace synthetic_dataset::randomize {
namespace {

/// Joins vertices at the same place: meshes repeat them where normals or textures differ.
void joinPlaces(const std::vector<const Eigen::Vector3d*>& places, double tolerance,
                JoinedSets& sets) {
  using Cell = std::array<std::int64_t, 3>;
  std::vector<std::pair<Cell, std::size_t>> cells;
  cells.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell[axis] = std::llround((*places[i])[static_cast<Eigen::Index>(axis)] / tolerance);
    }
    cells.emplace_back(cell, i);
  }
  std::sort(cells.begin(), cells.end());
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (cells[i].first == cells[i - 1].first) sets.join(cells[i].second, cells[i - 1].second);
  }
}

std::vector<SurfacePart> surfacesOf(const world::Model& model) {
  std::vector<SurfacePart> parts;
  for (std::size_t l = 0; l < model.links.size(); ++l) {
    const world::Link& link = model.links[l];
    for (std::size_t v = 0; v < link.visuals.size(); ++v) {
      for (std::size_t s = 0; s < link.visuals[v].surfaces.size(); ++s) {
        const auto& mesh = link.visuals[v].surfaces[s].mesh;
        if (!mesh || mesh->indices.empty()) continue;
        SurfacePart& part = parts.emplace_back();
        part.link = l;
        part.visual = v;
        part.surface = s;
        part.X_MV = link.X_ML * link.visuals[v].X_LV;
        part.p_M.reserve(mesh->positions.size());
        for (const Eigen::Vector3f& p : mesh->positions) {
          part.p_M.emplace_back(part.X_MV * p.cast<double>());
        }
      }
    }
  }
  return parts;
}

}  // namespace

ModelParts::ModelParts(const world::Model& model) : surfaces(surfacesOf(model)) {
  std::vector<const Eigen::Vector3d*> places;
  std::vector<std::size_t> first;
  for (const SurfacePart& part : surfaces) {
    first.push_back(places.size());
    for (const std::uint32_t index : surfaceOf(model, part).mesh->indices) {
      box_M.extend(part.p_M[index]);
    }
    for (const Eigen::Vector3d& p : part.p_M) places.push_back(&p);
  }
  if (box_M.isEmpty()) return;
  JoinedSets sets(places.size());
  joinPlaces(places, std::max(1e-5 * box_M.sizes().maxCoeff(), 1e-9), sets);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const std::vector<std::uint32_t>& indices = surfaceOf(model, surfaces[i]).mesh->indices;
    for (std::size_t k = 0; k + 2 < indices.size(); k += 3) {
      sets.join(first[i] + indices[k], first[i] + indices[k + 1]);
      sets.join(first[i] + indices[k], first[i] + indices[k + 2]);
    }
  }
  constexpr std::size_t kNone = ~std::size_t{0};
  std::vector<std::size_t> number(places.size(), kNone);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (std::size_t k = 0; k < surfaces[i].p_M.size(); ++k) {
      std::size_t& piece = number[sets.find(first[i] + k)];
      if (piece == kNone) {
        piece = pieces.size();
        pieces.emplace_back();
      }
      surfaces[i].piece.push_back(piece);
    }
    const SurfacePart& part = surfaces[i];
    const std::vector<std::uint32_t>& indices = surfaceOf(model, part).mesh->indices;
    for (std::size_t k = 0; k + 2 < indices.size(); k += 3) {
      const Eigen::Vector3d& a = part.p_M[indices[k]];
      const Eigen::Vector3d& b = part.p_M[indices[k + 1]];
      const Eigen::Vector3d& c = part.p_M[indices[k + 2]];
      MeshPiece& piece = pieces[part.piece[indices[k]]];
      for (const Eigen::Vector3d* corner : {&a, &b, &c}) piece.box_M.extend(*corner);
      const double size = 0.5 * (b - a).cross(c - a).norm();
      piece.area += size;
      area += size;
    }
  }
}

double areaOf(const world::Surface& surface, const SurfacePart& part) {
  double area = 0.0;
  const std::vector<std::uint32_t>& indices = surface.mesh->indices;
  for (std::size_t k = 0; k + 2 < indices.size(); k += 3) {
    const Eigen::Vector3d& a = part.p_M[indices[k]];
    area += 0.5 * (part.p_M[indices[k + 1]] - a).cross(part.p_M[indices[k + 2]] - a).norm();
  }
  return area;
}

}  // namespace synthetic_dataset::randomize
