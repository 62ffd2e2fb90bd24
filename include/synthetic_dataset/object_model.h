#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset {
inline namespace v2 {

/// An object's surface as triangles in its own frame, for formats that hold models.
struct ObjectModel {
  struct Vertex {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< p_O [m]
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();   ///< unit length, pointing outwards
    std::array<std::uint8_t, 3> colour{};                ///< red, green, blue (sRGB)
  };
  using Triangle = std::array<std::int32_t, 3>;  ///< vertex indices, counter-clockwise from outside

  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;

  /// The largest distance between two vertices [m].
  double diameter = 0.0;
};

/// Writes a model as PLY (ASCII; x y z, normal, colour; triangles as `vertex_indices`), which BOP's
/// and PVNet's loaders read. http://paulbourke.net/dataformats/ply/
/// @param scale  the file's units per metre: 1 for metres, 1000 for millimetres
void writePly(std::ostream& stream, const ObjectModel& model, double scale);

}  // namespace v2
}  // namespace synthetic_dataset
