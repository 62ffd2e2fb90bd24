#include "world/mesh/surface_points.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

constexpr int kFewestSamples = 4096;
constexpr int kSamplesAPoint = 64;

/// A point that may be chosen, with its position in the model at rest.
struct Candidate {
  SurfacePoint point;
  Eigen::Vector3d p_M;
};

struct Triangle {
  std::size_t link;
  Eigen::Vector3d corner_L, edge1_L, edge2_L;
  double area_until;  ///< of all triangles up to and including this one
};

double fraction(double value) { return value - std::floor(value); }

class Candidates {
 public:
  Candidates(const std::vector<const Link*>& links, int sample_count) : links_(links) {
    for (std::size_t i = 0; i < links.size(); ++i) {
      for (const Visual& visual : links[i]->visuals) addTriangles(i, visual);
    }
    addSamples(sample_count);
  }

  std::vector<Candidate> all;

 private:
  void add(std::size_t link, const Eigen::Vector3d& p_L) {
    all.push_back({{link, p_L}, links_[link]->X_ML * p_L});
  }

  void addTriangles(std::size_t link, const Visual& visual) {
    for (const Surface& surface : visual.surfaces) {
      const Mesh& mesh = *surface.mesh;
      std::vector<bool> used(mesh.positions.size(), false);
      for (const std::uint32_t index : mesh.indices) used[index] = true;
      for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i]) add(link, visual.X_LV * mesh.positions[i].cast<double>());
      }
      for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) -> Eigen::Vector3d {
          return visual.X_LV * mesh.positions[mesh.indices[i + k]].cast<double>();
        };
        const Eigen::Vector3d edge1 = corner(1) - corner(0);
        const Eigen::Vector3d edge2 = corner(2) - corner(0);
        area_ += 0.5 * edge1.cross(edge2).norm();
        triangles_.push_back({link, corner(0), edge1, edge2, area_});
      }
    }
  }

  /// Adds points spread evenly over the summed areas, placed in each triangle by the R2 sequence
  /// (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences"), folded into the
  /// triangle.
  void addSamples(int count) {
    if (!(area_ > 0.0)) return;
    constexpr double kPlastic = 1.32471795724474602596;  // the root of x^3 = x + 1
    for (int i = 0; i < count; ++i) {
      const double area = area_ * (i + 0.5) / count;
      const auto triangle = std::lower_bound(
          triangles_.begin(), triangles_.end(), area,
          [](const Triangle& each, double value) { return each.area_until < value; });
      double u = fraction(0.5 + i / kPlastic);
      double v = fraction(0.5 + i / (kPlastic * kPlastic));
      if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      add(triangle->link, triangle->corner_L + u * triangle->edge1_L + v * triangle->edge2_L);
    }
  }

  const std::vector<const Link*>& links_;
  std::vector<Triangle> triangles_;
  double area_ = 0.0;
};

}  // namespace

std::vector<SurfacePoint> farthestPoints(const std::vector<const Link*>& links, int count) {
  const Candidates candidates(links, std::max(kFewestSamples, kSamplesAPoint * count));
  Eigen::AlignedBox3d bounds;
  for (const Candidate& each : candidates.all) bounds.extend(each.p_M);
  // Squared distances to the nearest chosen point; initially to the centre.
  std::vector<double> distances;
  for (const Candidate& each : candidates.all) {
    distances.push_back((each.p_M - bounds.center()).squaredNorm());
  }
  std::vector<SurfacePoint> chosen;
  while (static_cast<int>(chosen.size()) < count) {
    const auto farthest = std::max_element(distances.begin(), distances.end());
    if (farthest == distances.end() || (!chosen.empty() && !(*farthest > 0.0))) {
      throw Error("its visuals have only " + std::to_string(chosen.size()) +
                  " different points, and " + std::to_string(count) + " are asked for");
    }
    const Candidate& next = candidates.all[static_cast<std::size_t>(farthest - distances.begin())];
    const bool is_first = chosen.empty();
    chosen.push_back(next.point);
    for (std::size_t i = 0; i < distances.size(); ++i) {
      const double distance = (candidates.all[i].p_M - next.p_M).squaredNorm();
      distances[i] = is_first ? distance : std::min(distances[i], distance);
    }
  }
  return chosen;
}

}  // namespace synthetic_dataset::world
