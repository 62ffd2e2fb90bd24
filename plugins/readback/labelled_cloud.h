#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset::formats {

/// A lidar's sweep as a format's files have it. Frame S: the scanner's, x ahead, y left, z up.
struct LabelledCloud {
  struct Point {
    Eigen::Vector3f position_S{0, 0, 0};  ///< [m]
    std::uint16_t ring = 0;               ///< where `has_rings`
    std::uint16_t number = 0;             ///< of its class, as the files have it; 0 for none
    std::uint16_t object = 0;             ///< of `objects`; 0 for none
  };

  struct Object {
    std::string class_name;
    std::string caption;                                      ///< which one it is: "rover 2"
    std::optional<std::array<Eigen::Vector3d, 8>> corners_S;  ///< as Cuboid::corners() [m]
  };

  std::string lidar;  ///< its name; empty: the files do not say
  std::vector<Point> points;
  bool has_rings = false;
  bool has_labels = false;                       ///< whether the files have a class of each point
  std::map<std::uint16_t, std::string> classes;  ///< their names by their numbers
  std::map<std::uint16_t, Object> objects;       ///< by their numbers
  std::optional<std::int64_t> rays;              ///< how many were sent
};

/// What a file has of a point's number of four bytes, the lowest first. @param at  its first byte
[[nodiscard]] float floatAt(const std::string& bytes, std::size_t at);
[[nodiscard]] std::uint32_t wordAt(const std::string& bytes, std::size_t at);

/// Adds points of files in KITTI's form: x, y, z [m] and an intensity, four numbers a point.
/// @throws Error naming the file where it ends within a point
void addVelodynePoints(LabelledCloud& cloud, const std::string& file);

/// Says of points within an object's box that they are its own: those of its class, and those of
/// none, which then have its class.
void assignToBoxes(LabelledCloud& cloud);

/// How many points each class has, by its number, 0 for none.
[[nodiscard]] std::map<std::uint16_t, std::int64_t> pointsOfClasses(const LabelledCloud& cloud);

/// How many points each of `objects` has.
[[nodiscard]] std::map<std::uint16_t, std::int64_t> pointsOfObjects(const LabelledCloud& cloud);

}  // namespace synthetic_dataset::formats
