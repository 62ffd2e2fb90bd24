#include "world/shape/shape_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "world/description.h"

namespace synthetic_dataset::world {
namespace {

// How Gazebo maps pictures onto its round shapes (gazebo/common/MeshManager.cc, CreateSphere and
// CreateCylinder, adopted by gz-sim).

/// The texture coordinates of a point of a surface.
struct PicturePoint {
  enum class Column {
    kTurns,  ///< u counts turns; where it jumps by a whole turn, the picture's edges meet
    kFixed,  ///< u is the same for all triangles
    kAny,    ///< a pole, where all columns of the picture meet
  };

  float u;
  float v;
  Column column = Column::kTurns;
};

/// The angle from one axis towards another in turns, 0 to 1.
float turns(float along, float across) {
  const auto turn = static_cast<float>(std::atan2(across, along) / (2.0 * M_PI));
  return turn < 0.0F ? turn + 1.0F : turn;
}

using Column = PicturePoint::Column;
using Corners = std::array<PicturePoint, 3>;

/// Moves the corners of a triangle by whole turns, so that each is within half a turn of its
/// middle; a pole is given the mean u of the others.
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

/// For a sphere centred at the origin: the picture is wrapped around the y axis, from z to x, with
/// its upper edge at +y.
PicturePoint aroundY(const Eigen::Vector3f& position, const Eigen::Vector3f& /*normal*/) {
  const float across = std::hypot(position.x(), position.z());
  const float v = static_cast<float>(std::atan2(across, position.y()) / M_PI);
  constexpr float kPole = 1e-5F;  // of the radius
  const bool is_pole = across < kPole * position.norm();
  return {turns(position.z(), position.x()), v, is_pole ? Column::kAny : Column::kTurns};
}

/// For a cylinder along the z axis: the picture is wrapped around it from y to x, with its upper
/// edge at the *bottom*. On the upper cap, it is drawn together to a fan with its first pixel at
/// the centre; on the lower cap, its first row is.
PicturePoint aroundCylinder(const Eigen::Vector3f& position, const Eigen::Vector3f& normal) {
  if (position.head<2>().isZero()) return {0.0F, 0.0F, Column::kFixed};
  const bool is_below = normal.z() < 0.0F || (normal.z() == 0.0F && position.z() < 0.0F);
  return {turns(position.y(), position.x()), is_below ? 0.0F : 1.0F};
}

/// Gives a mesh the texture coordinates of `wrapping`. Triangles are not moved; vertices at which
/// the picture's edges meet are duplicated.
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

/// A chord of n segments lies up to 1 - cos(pi / n) of the radius below its arc; on a sphere the
/// chords along meridians and parallels add up: 2 * 0.095 %.
constexpr int kSegments = 72;
constexpr int kStacks = kSegments / 2;

struct Vertex {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;
  Eigen::Vector2d texture_coordinate;
};

std::uint32_t add(Mesh& mesh, const Vertex& vertex) {
  mesh.positions.push_back(vertex.position.cast<float>());
  mesh.normals.push_back(vertex.normal.cast<float>());
  mesh.texture_coordinates.push_back(vertex.texture_coordinate.cast<float>());
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void addTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// Adds a rectangle with the texture upright on it. @param right, up  half of its sides
void addRectangle(Mesh& mesh, const Eigen::Vector3d& centre, const Eigen::Vector3d& right,
                  const Eigen::Vector3d& up) {
  const Eigen::Vector3d normal = right.cross(up).normalized();
  const std::uint32_t first = add(mesh, {centre - right - up, normal, {0, 1}});
  add(mesh, {centre + right - up, normal, {1, 1}});
  add(mesh, {centre + right + up, normal, {1, 0}});
  add(mesh, {centre - right + up, normal, {0, 0}});
  addTriangle(mesh, first, first + 1, first + 2);
  addTriangle(mesh, first, first + 2, first + 3);
}

/// A point of an outline that is revolved about z: distance from the axis, height, and the same two
/// for its normal; `v` is its texture coordinate.
struct OutlinePoint {
  double radius, height, normal_radius, normal_height, v;
};

/// Adds the surface of revolution of an outline about z. The outline runs from the top down.
void addLathe(Mesh& mesh, const std::vector<OutlinePoint>& outline) {
  const auto row = static_cast<std::uint32_t>(kSegments + 1);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const OutlinePoint& point : outline) {
    for (int i = 0; i <= kSegments; ++i) {
      // The last column lies exactly on the first one.
      const double angle = 2.0 * M_PI * (i % kSegments) / kSegments;
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      add(mesh, {{point.radius * c, point.radius * s, point.height},
                 {point.normal_radius * c, point.normal_radius * s, point.normal_height},
                 {static_cast<double>(i) / kSegments, point.v}});
    }
  }
  for (std::uint32_t j = 0; j + 1 < outline.size(); ++j) {
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      const std::uint32_t upper = first + j * row + i;
      const std::uint32_t lower = upper + row;
      if (outline[j].radius > 0.0) addTriangle(mesh, upper, lower, upper + 1);
      if (outline[j + 1].radius > 0.0) addTriangle(mesh, lower, lower + 1, upper + 1);
    }
  }
}

/// The outline of a sphere whose halves are pulled apart by `gap`, from pole to pole.
std::vector<OutlinePoint> roundOutline(double radius, double gap) {
  const double whole = M_PI * radius + gap;
  std::vector<OutlinePoint> outline;
  const auto addPoint = [&](int stack, double shift, double passed) {
    const bool pole = stack == 0 || stack == kStacks;
    const double angle = M_PI * stack / kStacks;
    const double s = pole ? 0.0 : std::sin(angle);
    const double c = std::cos(angle);
    outline.push_back({radius * s, radius * c + shift, s, c, (radius * angle + passed) / whole});
  };
  for (int i = 0; i <= kStacks / 2; ++i) addPoint(i, 0.5 * gap, 0.0);
  for (int i = kStacks / 2 + (gap > 0.0 ? 0 : 1); i <= kStacks; ++i) addPoint(i, -0.5 * gap, gap);
  return outline;
}

/// Adds a disc that closes a cylinder. @param side  1 for the upper one, -1 for the lower one
void addDisc(Mesh& mesh, double radius, double height, double side) {
  const Eigen::Vector3d normal(0, 0, side);
  const std::uint32_t centre = add(mesh, {{0, 0, height}, normal, {0.5, 0.5}});
  for (int i = 0; i < kSegments; ++i) {
    const double angle = 2.0 * M_PI * i / kSegments;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    add(mesh, {{radius * c, radius * s, height}, normal, {0.5 + 0.5 * c, 0.5 - 0.5 * side * s}});
  }
  for (std::uint32_t i = 0; i < kSegments; ++i) {
    const std::uint32_t here = centre + 1 + i;
    const std::uint32_t next = centre + 1 + (i + 1) % kSegments;
    side > 0.0 ? addTriangle(mesh, centre, here, next) : addTriangle(mesh, centre, next, here);
  }
}

}  // namespace

std::shared_ptr<const Mesh> boxMesh(const Eigen::Vector3d& size) {
  auto mesh = std::make_shared<Mesh>();
  const Eigen::Vector3d x(0.5 * size.x(), 0, 0);
  const Eigen::Vector3d y(0, 0.5 * size.y(), 0);
  const Eigen::Vector3d z(0, 0, 0.5 * size.z());
  addRectangle(*mesh, x, y, z);
  addRectangle(*mesh, -x, -y, z);
  addRectangle(*mesh, y, -x, z);
  addRectangle(*mesh, -y, x, z);
  addRectangle(*mesh, z, -y, x);
  addRectangle(*mesh, -z, -y, -x);
  return mesh;
}

std::shared_ptr<const Mesh> sphereMesh(double radius) {
  auto mesh = std::make_shared<Mesh>();
  addLathe(*mesh, roundOutline(radius, 0.0));
  wrapAsGazebo(*mesh, aroundY);
  return mesh;
}

std::shared_ptr<const Mesh> ellipsoidMesh(const Eigen::Vector3d& radii) {
  auto mesh = std::make_shared<Mesh>();
  addLathe(*mesh, roundOutline(1.0, 0.0));
  const Eigen::Vector3f scale = radii.cast<float>();
  for (Eigen::Vector3f& position : mesh->positions) position = position.cwiseProduct(scale);
  for (Eigen::Vector3f& normal : mesh->normals) {
    normal = normal.cwiseQuotient(scale).normalized();
  }
  return mesh;
}

std::shared_ptr<const Mesh> cylinderMesh(double radius, double length) {
  auto mesh = std::make_shared<Mesh>();
  const double half = 0.5 * length;
  addLathe(*mesh, {{radius, half, 1, 0, 0}, {radius, -half, 1, 0, 1}});
  addDisc(*mesh, radius, half, 1.0);
  addDisc(*mesh, radius, -half, -1.0);
  wrapAsGazebo(*mesh, aroundCylinder);
  return mesh;
}

std::shared_ptr<const Mesh> capsuleMesh(double radius, double length) {
  auto mesh = std::make_shared<Mesh>();
  addLathe(*mesh, roundOutline(radius, length));
  return mesh;
}

std::shared_ptr<const Mesh> planeMesh(const Eigen::Vector3d& normal, const Eigen::Vector2d& size) {
  auto mesh = std::make_shared<Mesh>();
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal);
  addRectangle(*mesh, Eigen::Vector3d::Zero(), turn * Eigen::Vector3d(0.5 * size.x(), 0, 0),
               turn * Eigen::Vector3d(0, 0.5 * size.y(), 0));
  return mesh;
}

}  // namespace synthetic_dataset::world
