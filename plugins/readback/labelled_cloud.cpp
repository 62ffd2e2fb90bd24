#include "plugins/readback/labelled_cloud.h"

#include <cstring>

#include <Eigen/LU>

#include "plugins/readback/files.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {
namespace {

/// Coordinates in which a box spans 0 to 1 along each axis.
class BoxFrame {
 public:
  explicit BoxFrame(const std::array<Eigen::Vector3d, 8>& corners_S) : origin_S_(corners_S[0]) {
    Eigen::Matrix3d axes;
    axes << corners_S[4] - origin_S_, corners_S[2] - origin_S_, corners_S[1] - origin_S_;
    is_flat_ = axes.determinant() == 0.0;
    if (!is_flat_) inverse_ = axes.inverse();
    for (int axis = 0; axis < 3; ++axis) margin_[axis] = kMargin / axes.col(axis).norm();
  }

  [[nodiscard]] bool holds(const Eigen::Vector3f& p_S) const {
    if (is_flat_) return false;
    const Eigen::Array3d place = inverse_ * (p_S.cast<double>() - origin_S_);
    return (place >= -margin_).all() && (place <= 1.0 + margin_).all();
  }

 private:
  static constexpr double kMargin = 0.02;  // noise and rounding [m]

  Eigen::Vector3d origin_S_;
  Eigen::Matrix<double, 3, 3, Eigen::DontAlign> inverse_;
  Eigen::Array<double, 3, 1, Eigen::DontAlign> margin_;
  bool is_flat_ = false;
};

/// The number of a class; a new one if it has none yet.
std::uint16_t numberOf(LabelledCloud& cloud, const std::string& class_name) {
  for (const auto& [number, name] : cloud.classes) {
    if (name == class_name) return number;
  }
  const std::uint16_t last = cloud.classes.empty() ? 0 : cloud.classes.rbegin()->first;
  const auto number = static_cast<std::uint16_t>(last + 1);
  cloud.classes[number] = class_name;
  return number;
}

}  // namespace

float floatAt(const std::string& bytes, std::size_t at) {
  float number = 0.0F;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

void addVelodynePoints(LabelledCloud& cloud, const std::string& file) {
  constexpr std::size_t kBytesOfAPoint = 16;
  const std::string bytes = readText(file);
  if (bytes.size() % kBytesOfAPoint != 0) throw Error("'" + file + "': it ends within a point");
  for (std::size_t at = 0; at < bytes.size(); at += kBytesOfAPoint) {
    cloud.points.emplace_back().position_S = {floatAt(bytes, at), floatAt(bytes, at + 4),
                                              floatAt(bytes, at + 8)};
  }
}

void assignToBoxes(LabelledCloud& cloud) {
  for (const auto& [object, description] : cloud.objects) {
    if (!description.corners_S) continue;
    const BoxFrame box(*description.corners_S);
    const std::uint16_t number = numberOf(cloud, description.class_name);
    for (LabelledCloud::Point& point : cloud.points) {
      const bool may_be = point.object == 0 && (point.number == 0 || point.number == number);
      if (!may_be || (cloud.has_labels && point.number == 0) || !box.holds(point.position_S)) {
        continue;
      }
      point.object = object;
      point.number = number;
    }
  }
}

std::map<std::uint16_t, std::int64_t> pointsOfClasses(const LabelledCloud& cloud) {
  std::map<std::uint16_t, std::int64_t> counts;
  for (const LabelledCloud::Point& point : cloud.points) ++counts[point.number];
  return counts;
}

std::map<std::uint16_t, std::int64_t> pointsOfObjects(const LabelledCloud& cloud) {
  std::map<std::uint16_t, std::int64_t> counts;
  for (const auto& [object, description] : cloud.objects) counts[object] = 0;
  for (const LabelledCloud::Point& point : cloud.points) {
    const auto count = counts.find(point.object);
    if (count != counts.end()) ++count->second;
  }
  return counts;
}

}  // namespace synthetic_dataset::formats
