#include "plugins/bop/bop_symmetries.h"

#include <cmath>
#include <optional>

namespace synthetic_dataset {
namespace {

std::optional<std::vector<double>> numbersOf(const Value& value, std::size_t count) {
  const auto* list = value.as<Value::List>();
  if (list == nullptr || list->size() != count) return std::nullopt;
  std::vector<double> numbers;
  for (const Value& entry : *list) {
    if (const auto* whole = entry.as<std::int64_t>()) {
      numbers.push_back(static_cast<double>(*whole));
    } else if (const auto* number = entry.as<double>()) {
      numbers.push_back(*number);
    } else {
      return std::nullopt;
    }
    if (!std::isfinite(numbers.back())) return std::nullopt;
  }
  return numbers;
}

/// A rigid transform of 16 numbers, row by row.
std::optional<Pose> poseOf(const Value& value) {
  const auto numbers = numbersOf(value, 16);
  if (!numbers) return std::nullopt;
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> matrix(numbers->data());
  constexpr double kTolerance = 1e-4;  // numbers are written with few digits
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const bool is_rigid = (rotation * rotation.transpose()).isIdentity(kTolerance) &&
                        rotation.determinant() > 0.0 &&
                        (matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm() < kTolerance;
  if (!is_rigid) return std::nullopt;
  Pose pose = Pose::Identity();
  pose.linear() = rotation;
  pose.translation() = matrix.topRightCorner<3, 1>();
  return pose;
}

std::optional<Eigen::Vector3d> vectorOf(const Value::Map& map, const std::string& name) {
  const auto entry = map.find(name);
  if (entry == map.end()) return std::nullopt;
  const auto numbers = numbersOf(entry->second, 3);
  if (!numbers) return std::nullopt;
  return Eigen::Vector3d(numbers->at(0), numbers->at(1), numbers->at(2));
}

std::optional<ContinuousSymmetry> continuousOf(const Value& value) {
  const auto* map = value.as<Value::Map>();
  if (map == nullptr || map->size() != (map->count("offset") != 0 ? 2U : 1U)) return std::nullopt;
  const auto axis = vectorOf(*map, "axis");
  const auto offset = map->count("offset") != 0
                          ? vectorOf(*map, "offset")
                          : std::optional<Eigen::Vector3d>(Eigen::Vector3d::Zero());
  if (!axis || !offset || !(axis->norm() > 0.0)) return std::nullopt;
  return ContinuousSymmetry{axis->normalized(), *offset};
}

/// The entries of a list, or the value itself where it is not one of these.
Value::List entriesOf(const Value& value) {
  const auto* list = value.as<Value::List>();
  if (list == nullptr) return {value};
  const bool is_one_matrix = list->size() == 16 && !list->front().is<Value::List>();
  return is_one_matrix ? Value::List{value} : *list;
}

}  // namespace

void readSymmetries(Parameters parameters, BopModel& model) {
  const Pose X_MO = model.X_OM.inverse();
  model.discrete_symmetries.clear();
  model.continuous_symmetries.clear();
  for (const Value& entry :
       entriesOf(parameters.maybe<Value>("discrete").value_or(Value::List{}))) {
    if (const auto symmetry_O = poseOf(entry)) {
      model.discrete_symmetries.push_back(X_MO * *symmetry_O * model.X_OM);
    } else {
      parameters.addError("discrete", "found " + entry.text() +
                                          "; it should be a rigid transform of 16 numbers, row by "
                                          "row, or a list of such");
    }
  }
  for (const Value& entry :
       entriesOf(parameters.maybe<Value>("continuous").value_or(Value::List{}))) {
    if (const auto symmetry_O = continuousOf(entry)) {
      model.continuous_symmetries.push_back({symmetry_O->axis, X_MO * symmetry_O->offset});
    } else {
      parameters.addError("continuous", "found " + entry.text() +
                                            "; it should be {axis: [x, y, z], offset: [x, y, z]}, "
                                            "or a list of such");
    }
  }
}

}  // namespace synthetic_dataset
