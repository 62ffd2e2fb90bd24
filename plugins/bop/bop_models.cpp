#include "plugins/bop/bop_models.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "plugins/shared/json.h"
#include "plugins/shared/pose_formats.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset {
namespace {

std::optional<std::vector<double>> listedNumbers(const Value& value, std::size_t count) {
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
  const auto numbers = listedNumbers(value, 16);
  if (!numbers) return std::nullopt;
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> matrix(numbers->data());
  constexpr double kTolerance = 1e-4;  // numbers are written with only a few digits
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
  const auto numbers = listedNumbers(entry->second, 3);
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

/// The entries of a list, or the value itself if it is not a list of entries.
Value::List entriesOf(const Value& value) {
  const auto* list = value.as<Value::List>();
  if (list == nullptr) return {value};
  const bool is_one_matrix = list->size() == 16 && !list->front().is<Value::List>();
  return is_one_matrix ? Value::List{value} : *list;
}

/// Reads an object's symmetries: `discrete`, transforms of 16 numbers each, row by row [m], and
/// `continuous`, axes with an offset [m]; both in the object's frame. Adds errors to `parameters`.
/// @param model  its symmetries are replaced by these, in its own frame
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

std::vector<std::string> namesOf(const DatasetInfo& dataset) {
  std::vector<std::string> names;
  for (const ObjectInfo& object : dataset.objects) names.push_back(object.name);
  return names;
}

/// Adds an error for each entry of a group that is not an object's name.
void requireObjectNames(Parameters& group, const DatasetInfo& dataset) {
  const std::vector<std::string> objects = namesOf(dataset);
  for (const std::string& name : group.names()) {
    if (std::find(objects.begin(), objects.end(), name) != objects.end()) continue;
    group.ignore(name);
    group.addError(name, "no object has this name" + didYouMean(name, objects));
  }
}

std::vector<int> readObjIds(Parameters& parameters, const DatasetInfo& dataset) {
  Parameters group = parameters.group("obj_ids");
  requireObjectNames(group, dataset);
  std::vector<std::optional<int>> given;
  std::set<int> taken;
  for (const ObjectInfo& object : dataset.objects) {
    given.push_back(group.maybe<int>(object.name));
    if (!given.back()) continue;
    taken.insert(*given.back());
    if (*given.back() < 1) {
      group.addError(object.name, "found " + std::to_string(*given.back()) +
                                      "; it should be a whole number from 1");
    }
  }
  std::vector<int> ids;
  int next = 1;
  for (const std::optional<int>& id : given) {
    while (!id && taken.count(next) != 0) ++next;
    ids.push_back(id ? *id : next++);
  }
  return ids;
}

BopModel measured(const ObjectModel& model, std::size_t object, bool is_centred) {
  BopModel result;
  result.object = object;
  result.has_surface = !model.vertices.empty();
  if (!result.has_surface) return result;
  const Cuboid bounds_O = boundsOf(model);
  if (is_centred) result.X_OM.translation() = bounds_O.centre();
  const Eigen::Vector3d origin_O = result.X_OM.translation();
  result.bounds_M = {bounds_O.low - origin_O, bounds_O.high - origin_O};
  result.diameter = model.diameter;
  return result;
}

/// Whether two models have the same surface, judged by their extents.
bool areAlike(const BopModel& a, const BopModel& b) {
  constexpr double kTolerance = 1e-6;  // [m]
  return a.has_surface == b.has_surface && a.bounds_M.low.isApprox(b.bounds_M.low, kTolerance) &&
         a.bounds_M.high.isApprox(b.bounds_M.high, kTolerance) &&
         std::abs(a.diameter - b.diameter) < kTolerance;
}

/// 16 numbers, row by row, the translation in millimetres.
Json transformOf(const Pose& pose) {
  Json numbers = Json::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) numbers.push_back(pose.linear()(row, column));
    numbers.push_back(kMillimetres * pose.translation()(row));
  }
  for (const double number : {0.0, 0.0, 0.0, 1.0}) numbers.push_back(number);
  return numbers;
}

/// An entry of models_info.json.
Json infoOf(const BopModel& model) {
  const Eigen::Vector3d low = kMillimetres * model.bounds_M.low;
  const Eigen::Vector3d size = kMillimetres * model.bounds_M.size();
  Json info = {{"diameter", kMillimetres * model.diameter},
               {"min_x", low.x()},
               {"min_y", low.y()},
               {"min_z", low.z()},
               {"size_x", size.x()},
               {"size_y", size.y()},
               {"size_z", size.z()}};
  for (const Pose& symmetry_M : model.discrete_symmetries) {
    info["symmetries_discrete"].push_back(transformOf(symmetry_M));
  }
  for (const ContinuousSymmetry& symmetry_M : model.continuous_symmetries) {
    info["symmetries_continuous"].push_back(
        {{"axis", numbersOf(symmetry_M.axis)},
         {"offset", numbersOf(kMillimetres * symmetry_M.offset)}});
  }
  return info;
}

Json infosOf(const BopModels& models) {
  Json infos = Json::object();
  for (const auto& [id, model] : models.by_id) {
    if (model.has_surface) infos[std::to_string(id)] = infoOf(model);
  }
  return infos;
}

ObjectModel inModelFrame(ObjectModel model, const Pose& X_OM) {
  for (ObjectModel::Vertex& vertex : model.vertices) vertex.position -= X_OM.translation();
  return model;
}

}  // namespace

BopModels readBopModels(Parameters& parameters, const DatasetInfo& dataset) {
  BopModels models;
  models.obj_ids = readObjIds(parameters, dataset);
  const bool is_centred = parameters.optional("centre_models", true);
  Parameters symmetries = parameters.group("symmetries");
  requireObjectNames(symmetries, dataset);
  for (std::size_t i = 0; i < dataset.objects.size(); ++i) {
    const int id = models.obj_ids[i];
    const std::string& name = dataset.objects[i].name;
    const BopModel model = measured(dataset.model(i), i, is_centred);
    const auto [known, is_new] = models.by_id.emplace(id, model);
    if (!is_new && !areAlike(known->second, model)) {
      parameters.group("obj_ids").addError(
          name, "found " + std::to_string(id) + ", the number of '" +
                    dataset.objects[known->second.object].name +
                    "', whose model is different; only objects of the same model may share one");
    }
    if (symmetries.has(name)) readSymmetries(symmetries.group(name), models.by_id[id]);
  }
  return models;
}

void addBopModels(const BopModels& models, const DatasetInfo& dataset, DatasetOutput& output) {
  const std::vector<std::string> folders = {"models/", "models_eval/"};
  for (const auto& [id, model] : models.by_id) {
    if (!model.has_surface) continue;
    const ObjectModel surface_M = inModelFrame(dataset.model(model.object), model.X_OM);
    for (const std::string& folder : folders) {
      output.addFile(folder + "obj_" + sixDigits(id) + ".ply",
                     [&](std::ostream& stream) { writePly(stream, surface_M, kMillimetres); });
    }
  }
  const std::string infos = indentedJson(infosOf(models));
  for (const std::string& folder : folders) output.addText(folder + "models_info.json", infos);
}

}  // namespace synthetic_dataset
