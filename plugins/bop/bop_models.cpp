#include "plugins/bop/bop_models.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <set>

#include "plugins/bop/bop_symmetries.h"
#include "plugins/shared/json.h"
#include "plugins/shared/pose_formats.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset {
namespace {

std::vector<std::string> namesOf(const DatasetInfo& dataset) {
  std::vector<std::string> names;
  for (const ObjectInfo& object : dataset.objects) names.push_back(object.name);
  return names;
}

/// Notes an error for each entry of a group that is no object's name.
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

/// Whether two models are the same surface, as far as their extents show.
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
                    "', whose model is another; only objects of the same model may share one");
    }
    if (symmetries.has(name)) readSymmetries(symmetries.group(name), models.by_id[id]);
  }
  return models;
}

void addBopModels(const BopModels& models, const DatasetInfo& dataset, DatasetOutput& output) {
  for (const auto& [id, model] : models.by_id) {
    if (!model.has_surface) continue;
    const ObjectModel surface_M = inModelFrame(dataset.model(model.object), model.X_OM);
    for (const char* folder : {"models/", "models_eval/"}) {
      output.addFile(folder + ("obj_" + sixDigits(id) + ".ply"),
                     [&](std::ostream& stream) { writePly(stream, surface_M, kMillimetres); });
    }
  }
  const std::string infos = indentedJson(infosOf(models));
  for (const char* folder : {"models/", "models_eval/"}) {
    output.addFile(folder + std::string("models_info.json"),
                   [&](std::ostream& stream) { stream << infos; });
  }
}

}  // namespace synthetic_dataset
