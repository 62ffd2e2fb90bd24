#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset::formats {

/// A lidar's sweep as read from a format's files. Frame S: the scanner's, x ahead, y left, z up.
struct LabelledCloud {
  struct Point {
    Eigen::Vector3f position_S{0, 0, 0};  ///< [m]
    std::uint16_t ring = 0;               ///< valid if `has_rings`
    std::uint16_t number = 0;             ///< of its class, as in the files; 0 for none
    std::uint16_t object = 0;             ///< key in `objects`; 0 for none
  };

  struct Object {
    std::string class_name;
    std::string caption;                                      ///< identifies the object: "rover 2"
    std::optional<std::array<Eigen::Vector3d, 8>> corners_S;  ///< as Cuboid::corners() [m]
  };

  std::string lidar;  ///< its name; empty: the files do not say
  std::vector<Point> points;
  bool has_rings = false;
  bool has_labels = false;                       ///< whether the files give each point's class
  std::map<std::uint16_t, std::string> classes;  ///< names by number
  std::map<std::uint16_t, Object> objects;       ///< by number
  std::optional<std::int64_t> rays;              ///< how many were sent
};

/// Reads a four-byte number, little-endian, from a file's content. @param at  its first byte
[[nodiscard]] float floatAt(const std::string& bytes, std::size_t at);
[[nodiscard]] std::uint32_t wordAt(const std::string& bytes, std::size_t at);

/// Adds the points of a file in KITTI's form: x, y, z [m] and an intensity, four numbers per point.
/// @throws Error naming the file if it ends within a point
void addVelodynePoints(LabelledCloud& cloud, const std::string& file);

/// Assigns points within an object's box to the object if they have its class or, in clouds without
/// labels, no class; the latter receive its class.
void assignToBoxes(LabelledCloud& cloud);

/// The number of points of each class, by class number, 0 for none.
[[nodiscard]] std::map<std::uint16_t, std::int64_t> pointsOfClasses(const LabelledCloud& cloud);

/// The number of points of each of `objects`.
[[nodiscard]] std::map<std::uint16_t, std::int64_t> pointsOfObjects(const LabelledCloud& cloud);

}  // namespace synthetic_dataset::formats
