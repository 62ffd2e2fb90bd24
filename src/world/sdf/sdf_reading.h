#pragma once

/// What the readers of SDF's elements share. Types of libsdformat's mathematics appear only as
/// template parameters: their namespace changes with its version.

#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <sdf/Element.hh>
#include <sdf/SemanticPose.hh>

#include "synthetic_dataset/pose.h"
#include "world/files/findings.h"
#include "world/files/resource_finder.h"
#include "world/mesh/mesh_loader.h"
#include "world/shape/shape_cache.h"

namespace synthetic_dataset::world {

/// One file being read.
struct SdfReading {
  std::filesystem::path file;
  const ResourceFinder& finder;
  MeshLoader& meshes;
  ShapeCache& shapes;
  Findings& findings;
  bool sound = true;      ///< false: libsdformat has complained, and poses may be unknown for it
  bool is_of_gz = false;  ///< something was found that only gz-sim has

  /// A file that an element names is missing or unreadable, and the element is left out: an error,
  /// or a note where the user would rather have the rest.
  void missing(const std::string& message) { findings.addMissing(message); }

  /// The folder to which URIs in an element's file are relative.
  [[nodiscard]] std::filesystem::path folderOf(const sdf::ElementPtr& element) const;
};

template <class Vector3>
[[nodiscard]] Eigen::Vector3d toEigen(const Vector3& v) {
  return {v.X(), v.Y(), v.Z()};
}

template <class Pose3>
[[nodiscard]] Pose toPose(const Pose3& pose) {
  return makePose(toEigen(pose.Pos()), Eigen::Quaterniond(pose.Rot().W(), pose.Rot().X(),
                                                          pose.Rot().Y(), pose.Rot().Z()));
}

template <class Color>
[[nodiscard]] Eigen::Vector4f toColour(const Color& colour) {
  return {colour.R(), colour.G(), colour.B(), colour.A()};
}

/// The pose in the frame that libsdformat takes for granted: of a model in the world, of a link in
/// its model, of all else in its link.
[[nodiscard]] Pose resolve(const sdf::SemanticPose& pose, const Place& place, SdfReading& reading);

/// The element at a path of names below `parent`, or null where the file has none.
[[nodiscard]] sdf::ElementPtr descendant(const sdf::ElementPtr& parent,
                                         std::initializer_list<const char*> path);

/// Whether the file has such an element.
[[nodiscard]] bool has(const sdf::ElementPtr& parent, const char* name);

/// The numbers that an element's text lists, up to the first word that is none.
[[nodiscard]] std::vector<double> numbers(const sdf::ElementPtr& element);

/// A number of the file, or the fallback where it has none.
[[nodiscard]] double number(const sdf::ElementPtr& parent, std::initializer_list<const char*> path,
                            double fallback);

}  // namespace synthetic_dataset::world
