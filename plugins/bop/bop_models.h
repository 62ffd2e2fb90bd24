#pragma once

#include <map>
#include <vector>

#include "synthetic_dataset/label_writer.h"

/// The object models of a dataset in BOP's format.
namespace synthetic_dataset {

inline constexpr double kMillimetres = 1000.0;  ///< per metre

/// A symmetry of a model that looks the same when rotated by any angle about an axis.
struct ContinuousSymmetry {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< a point on the axis [m]
};

/// One of BOP's models. Frames: O is the object's and M the model's; their axes are parallel.
struct BopModel {
  std::size_t object = 0;  ///< index in DatasetInfo::objects of the object whose model it is
  bool has_surface = false;
  Pose X_OM = Pose::Identity();
  Cuboid bounds_M;                                        ///< [m]
  double diameter = 0.0;                                  ///< [m]
  std::vector<Pose> discrete_symmetries;                  ///< from M to M
  std::vector<ContinuousSymmetry> continuous_symmetries;  ///< in M
};

/// All models, and the model of each object.
struct BopModels {
  std::vector<int> obj_ids;       ///< of each object
  std::map<int, BopModel> by_id;  ///< by obj_id, from 1

  [[nodiscard]] const BopModel& of(std::size_t object) const {
    return by_id.at(obj_ids.at(object));
  }
};

/// Reads `obj_ids`, `centre_models` and `symmetries`, and measures the models.
[[nodiscard]] BopModels readBopModels(Parameters& parameters, const DatasetInfo& dataset);

/// Writes the folders `models` and `models_eval`.
void addBopModels(const BopModels& models, const DatasetInfo& dataset, DatasetOutput& output);

}  // namespace synthetic_dataset
