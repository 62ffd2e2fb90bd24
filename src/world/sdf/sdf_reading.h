#pragma once

#include <functional>
#include <string>
#include <vector>

#include "world/files/findings.h"
#include "world/files/resource_finder.h"
#include "world/material/material_source.h"
#include "world/material/texture_loader.h"
#include "world/mesh/mesh_loader.h"
#include "world/sdf/element.h"
#include "world/sdf/sdf_file.h"
#include "world/shape/shape_cache.h"

namespace synthetic_dataset::world {

/// The files that a world will need, all of which exist.
struct SdfSurvey {
  std::vector<MeshAhead> meshes;
  std::vector<TextureReference> pictures;

  void addPicturesOf(const MaterialSource& source) {
    for (const auto* reference : referencesOf(source)) {
      if (*reference) pictures.push_back(**reference);
    }
  }
};

struct SdfReading;

/// A robot that a URDF file describes.
struct UrdfModel {
  Model model;
  std::vector<CameraSensor> cameras;
  std::vector<LidarSensor> lidars;
};

/// Reads a URDF file; see readUrdfModel().
using UrdfReader = std::function<UrdfModel(const SdfFile& file, SdfReading& reading)>;

/// The inputs and findings of reading SDF. One rule holds for all elements: those that this program
/// does not use are not examined; if one that it uses cannot be understood, only that one is
/// affected (a default replaces it, or its shape is left out), with a note that says file, line,
/// what was found and what was done.
struct SdfReading {
  const ResourceFinder& finder;
  MeshLoader& meshes;
  ShapeCache& shapes;
  SdfFiles& files;
  Findings& findings;
  UrdfReader readUrdf;    ///< for the URDF files that are included
  bool is_of_gz = false;  ///< something was found that only gz-sim has

  /// If set, meshes and pictures are looked for and listed but not read: what is missing is
  /// reported before anything large is read, and the rest can be read in parallel.
  SdfSurvey* survey = nullptr;

  /// Reports that a file that an element names is missing or unreadable, and that the element is
  /// left out: an error, or a note if the user would rather have the rest.
  void missing(const SourceLocation& location, const std::string& thing) {
    findings.addMissing(location, thing);
  }
};

/// The location of an element in an outer one, with its `name`.
[[nodiscard]] inline SourceLocation locationOf(const Element& element, const SourceLocation& outer,
                                               const std::string& name) {
  const SourceLocation there = outer.inFile(element.file().path.string()).atLine(element.line());
  return name.empty() ? there.in(element.name()) : there.in(element.name(), name);
}

[[nodiscard]] inline SourceLocation locationOf(const Element& element,
                                               const SourceLocation& outer) {
  return locationOf(element, outer, element.attribute("name"));
}

}  // namespace synthetic_dataset::world
