#include "world/sdf/sdf_populations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Core>

#include "base/random/random_source.h"
#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kMostPopulated = 10000.0;

/// Three numbers from 0 to 1 for each model.
using Draw = std::function<Eigen::Vector3d(std::size_t index)>;

/// Evenly spread points, above all in x and y: the additive recurrences of the root of x^3 = x + 1
/// in x and y, and of the golden ratio in z (Roberts 2018, "The unreasonable effectiveness of
/// quasirandom sequences").
Eigen::Vector3d evenly(std::size_t index) {
  constexpr double kRoot = 1.324717957244746;
  constexpr double kGolden = 1.618033988749895;
  static const Eigen::Vector3d kSteps(1.0 / kRoot, 1.0 / (kRoot * kRoot), 1.0 / kGolden);
  Eigen::Vector3d result = Eigen::Vector3d::Constant(0.5) + static_cast<double>(index + 1) * kSteps;
  for (int axis = 0; axis < 3; ++axis) result[axis] -= std::floor(result[axis]);
  return result;
}

/// A whole number from 1 to 10000; nothing, with a note, if it is not.
std::optional<std::size_t> readCount(const Element& parent, const char* name,
                                     const SourceLocation& location, SdfReading& reading) {
  const double count = readNumber(parent, name, 0.0, location, reading);
  if (count >= 1.0 && count <= kMostPopulated) return static_cast<std::size_t>(count);
  reading.findings.addNote(location, std::string(name) + ": found " + shortText(count) +
                                         "; it should be 1 to 10000; the population is left out");
  return std::nullopt;
}

/// Computes where the models of a population are.
class PopulationReader {
 public:
  PopulationReader(const Element& population, const SourceLocation& location, SdfReading& reading)
      : population_(population), location_(location), reading_(reading) {}

  /// The positions in the world; none, with a note, if the file does not define them.
  std::vector<Eigen::Vector3d> positions() {
    const Element distribution = population_.child("distribution");
    const std::string type = readText(distribution, "type");
    std::vector<Eigen::Vector3d> offsets;
    if (type == "grid") {
      offsets = gridOf(distribution);
    } else if (const auto count = readCount(population_, "model_count", location_, reading_)) {
      offsets = regionOf(type, *count);
    }
    const Pose X_WP = readPose(population_, location_, reading_).pose;
    for (Eigen::Vector3d& each : offsets)
      each = X_WP.linear() * each + corner_ + X_WP.translation();
    return offsets;
  }

 private:
  /// The population's pose is the centre of the grid.
  std::vector<Eigen::Vector3d> gridOf(const Element& distribution) {
    const auto rows = readCount(distribution, "rows", location_, reading_);
    const auto columns = readCount(distribution, "cols", location_, reading_);
    if (!rows || !columns) return {};
    if (static_cast<double>(*rows) * static_cast<double>(*columns) > kMostPopulated) {
      note("of " + std::to_string(*rows) + " x " + std::to_string(*columns) +
           " models is more than 10000");
      return {};
    }
    const Eigen::Vector3d step =
        readVector(distribution, "step", Eigen::Vector3d::Zero(), location_, reading_);
    corner_ = -0.5 * Eigen::Vector3d(step.x() * static_cast<double>(*columns - 1),
                                     step.y() * static_cast<double>(*rows - 1), 0.0);
    std::vector<Eigen::Vector3d> offsets;
    for (std::size_t row = 0; row < *rows; ++row) {
      for (std::size_t column = 0; column < *columns; ++column) {
        offsets.emplace_back(step.x() * static_cast<double>(column),
                             step.y() * static_cast<double>(row), 0.0);
      }
    }
    return offsets;
  }

  std::vector<Eigen::Vector3d> regionOf(const std::string& type, std::size_t count) {
    if (const Element box = population_.child("box")) return boxOf(box, type, count);
    if (const Element cylinder = population_.child("cylinder")) {
      return cylinderOf(cylinder, type, count);
    }
    note("has no <box> and no <cylinder>");
    return {};
  }

  /// The population's pose is the centre of the box.
  std::vector<Eigen::Vector3d> boxOf(const Element& box, const std::string& type,
                                     std::size_t count) {
    const Eigen::Vector3d size =
        readVector(box, "size", Eigen::Vector3d::Zero(), location_, reading_);
    if (!(size.minCoeff() > 0.0)) {
      note("has a box without a volume");
      return {};
    }
    corner_ = -0.5 * size;
    static const std::array<std::string, 3> kLines = {"linear-x", "linear-y", "linear-z"};
    const auto line = std::find(kLines.begin(), kLines.end(), type);
    if (line == kLines.end()) {
      return drawn(type, count, [&](const Eigen::Vector3d& at) { return at.cwiseProduct(size); });
    }
    std::vector<Eigen::Vector3d> offsets(count, 0.5 * size);
    const auto axis = static_cast<Eigen::Index>(line - kLines.begin());
    for (std::size_t i = 0; i < count; ++i) {
      offsets[i][axis] = size[axis] * static_cast<double>(i) / static_cast<double>(count);
    }
    return offsets;
  }

  /// The population's pose is the centre of the cylinder's base. At random, Gazebo draws the
  /// distance from the axis uniformly, so that there are more models near the axis.
  std::vector<Eigen::Vector3d> cylinderOf(const Element& cylinder, const std::string& type,
                                          std::size_t count) {
    const double radius = readNumber(cylinder, "radius", 0.0, location_, reading_);
    const double length = readNumber(cylinder, "length", 0.0, location_, reading_);
    if (!(radius > 0.0 && length > 0.0)) {
      note("has a cylinder without a volume");
      return {};
    }
    const bool is_even = type == "uniform";
    return drawn(type, count, [&](const Eigen::Vector3d& at) {
      const double distance = radius * (is_even ? std::sqrt(at.y()) : at.y());
      const double angle = kTwoPi * at.x();
      return Eigen::Vector3d(distance * std::cos(angle), distance * std::sin(angle),
                             length * at.z());
    });
  }

  template <class Place01>
  std::vector<Eigen::Vector3d> drawn(const std::string& type, std::size_t count,
                                     const Place01& in_region) {
    base::RandomSource random(0, 0, "population " + population_.attribute("name"));
    Draw draw = evenly;
    if (type == "random") {
      draw = [&](std::size_t) {
        const double x = random.unit();
        const double y = random.unit();
        return Eigen::Vector3d(x, y, random.unit());
      };
    } else if (type != "uniform") {
      note("has the distribution '" + type + "', which its region cannot have");
      return {};
    }
    std::vector<Eigen::Vector3d> offsets;
    for (std::size_t i = 0; i < count; ++i) offsets.push_back(in_region(draw(i)));
    return offsets;
  }

  void note(const std::string& what) {
    reading_.findings.addNote(location_, "the population " + what + "; it is left out");
  }

  const Element& population_;
  const SourceLocation& location_;
  SdfReading& reading_;
  Eigen::Vector3d corner_ = Eigen::Vector3d::Zero();  ///< of the region, before the pose
};

}  // namespace

std::vector<ModelSource> readPopulation(const Element& population, const SourceLocation& outer,
                                        SdfIncludes& includes, SdfReading& reading) {
  const SourceLocation location = locationOf(population, outer);
  const Element model = population.child("model");
  if (!model) {
    reading.findings.addNote(location, "has no <model>; the population is left out");
    return {};
  }
  std::vector<ModelSource> models;
  for (const Eigen::Vector3d& p_W : PopulationReader(population, location, reading).positions()) {
    ModelSource source = includes.modelOf(model, location);
    source.name += "_clone_" + std::to_string(models.size());
    source.pose = {};
    source.pose.pose.translation() = p_W;
    models.push_back(std::move(source));
  }
  return models;
}

}  // namespace synthetic_dataset::world
