#include "world/sdf/sdf_roads.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "world/material/gazebo_materials.h"
#include "world/sdf/sdf_materials.h"
#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

std::vector<Eigen::Vector3d> readPoints(const Element& road, const SourceLocation& location,
                                        SdfReading& reading) {
  std::vector<Eigen::Vector3d> points;
  for (const Element& point : road.children("point")) {
    const std::vector<double> v = numbersIn(point.text());
    if (v.size() < 3) {
      reading.findings.addNote(
          location.atLine(point.line()),
          "point: found '" + point.text() + "'; three numbers are needed; it is left out");
    } else {
      points.emplace_back(v[0], v[1], v[2]);
    }
  }
  return points;
}

/// The direction across the road at a point, to its left, lengthened so that the strip keeps its
/// width in a bend.
Eigen::Vector3d acrossAt(const std::vector<Eigen::Vector3d>& points, std::size_t i) {
  const Eigen::Vector2d before = (points[i] - points[i > 0 ? i - 1 : i]).head<2>().normalized();
  const Eigen::Vector2d after =
      (points[i + 1 < points.size() ? i + 1 : i] - points[i]).head<2>().normalized();
  const Eigen::Vector2d along = (before + after).normalized();
  const Eigen::Vector2d& side = i > 0 ? before : after;
  constexpr double kSharpest = 0.2;  // least cosine of half a bend: hairpins get no endless spikes
  return Eigen::Vector3d(-along.y(), along.x(), 0.0) / std::max(kSharpest, along.dot(side));
}

/// The texture is as long as the road is wide.
std::shared_ptr<const Mesh> stripOf(const std::vector<Eigen::Vector3d>& points, double width) {
  auto mesh = std::make_shared<Mesh>();
  double length = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) length += (points[i] - points[i - 1]).norm();
    const Eigen::Vector3d across = 0.5 * width * acrossAt(points, i);
    for (const double side : {1.0, -1.0}) {
      mesh->positions.push_back((points[i] + side * across).cast<float>());
      mesh->normals.emplace_back(0.0F, 0.0F, 1.0F);
      mesh->texture_coordinates.emplace_back(side > 0.0 ? 0.0F : 1.0F,
                                             static_cast<float>(length / width));
    }
    if (i == 0) continue;
    const auto last = static_cast<std::uint32_t>(2 * i - 2);
    mesh->indices.insert(mesh->indices.end(),
                         {last, last + 1, last + 2, last + 2, last + 1, last + 3});
  }
  return mesh;
}

Material materialOf(const Element& road, const SourceLocation& location, SdfReading& reading) {
  if (auto material = readSdfMaterial(road, location, reading)) return *material;
  return gazeboMaterial("Gazebo/Road", reading.meshes.textures()).value_or(defaultMaterial());
}

}  // namespace

Model readRoad(const Element& road, const SourceLocation& location, SdfReading& reading) {
  Model model;
  model.name = road.attribute("name");
  model.is_static = true;
  const std::vector<Eigen::Vector3d> points = readPoints(road, location, reading);
  const double width = readNumber(road, "width", 1.0, location, reading);
  if (points.size() < 2 || !(width > 0.0)) {
    reading.findings.addNote(location,
                             "a width above 0 and two points or more are needed; it is left out");
    return model;
  }
  Visual visual;
  visual.name = "road";
  visual.casts_shadow = false;
  visual.surfaces.push_back({stripOf(points, width), materialOf(road, location, reading)});
  Link link;
  link.name = "link";
  link.visuals.push_back(std::move(visual));
  model.links.push_back(std::move(link));
  return model;
}

}  // namespace synthetic_dataset::world
