#include "world/sdf_loader.h"

#include <exception>
#include <filesystem>
#include <optional>
#include <utility>

#include "synthetic_dataset/errors.h"
#include "world/findings.h"
#include "world/include_graph.h"
#include "world/mesh_loader.h"
#include "world/model_config.h"
#include "world/sdf_document.h"
#include "world/sdf_lights.h"
#include "world/sdf_models.h"
#include "world/sdf_reading.h"
#include "world/sdf_worlds.h"
#include "world/shape_cache.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

/// The file that a URI of the user's means.
fs::path fileFor(const std::string& uri, const ResourceFinder& finder) {
  const fs::path here = fs::current_path();
  const std::optional<fs::path> found = finder.find(uri, here);
  if (!found) {
    throw ErrorList({"'" + uri + "': no such file; " + finder.searchedPlaces(uri, here)});
  }
  if (found->extension() == ".xacro") {
    throw ErrorList({found->string() + ": is a xacro file; name the URDF that xacro makes of it"});
  }
  try {
    return fs::is_directory(*found) ? modelFileOf(*found) : *found;
  } catch (const std::exception& error) {
    throw ErrorList({uri + ": " + error.what()});
  }
}

/// The pose of what stands alone in its file, which libsdformat cannot always resolve.
Pose lonePose(const sdf::SemanticPose& pose) {
  auto resolved = pose.RawPose();
  const bool known = pose.Resolve(resolved).empty();
  return toPose(known ? resolved : pose.RawPose());
}

Description describeFile(const SdfDocument& document, const SdfLoadOptions& options,
                         const Place& place, SdfReading& reading) {
  Description description;
  if (document.world() != nullptr) {
    readWorld(*document.world(), options, place, reading, description);
  } else if (document.model() != nullptr) {
    const sdf::Model& model = *document.model();
    ModelContents contents =
        readModel(model, lonePose(model.SemanticPose()), options, place, reading);
    description.models.push_back(std::move(contents.model));
    description.lights = std::move(contents.lights);
    description.cameras = std::move(contents.cameras);
  } else if (document.light() != nullptr) {
    const sdf::Light& light = *document.light();
    const Pose X_WL = lonePose(light.SemanticPose());
    description.lights.push_back(readLight(light, light.Name(), X_WL, place, reading));
  } else if (document.isSound()) {
    reading.findings.addError(place.message("holds neither a world nor a model nor a light"));
  }
  return description;
}

}  // namespace

struct SdfLoader::Caches {
  explicit Caches(const ResourceFinder& finder) : meshes(finder) {}

  MeshLoader meshes;
  ShapeCache shapes;
};

SdfLoader::SdfLoader(const ResourceFinder& finder, const SdfLoadOptions& options)
    : finder_(finder), options_(options), caches_(std::make_unique<Caches>(finder)) {}

SdfLoader::~SdfLoader() = default;

Description SdfLoader::loadWorld(const std::string& uri) {
  const fs::path file = fileFor(uri, finder_);
  Findings findings;
  const IncludeGraph includes(file, finder_, findings);
  if (!includes.isReadable()) findings.throwErrors();
  const SdfDocument document(file, includes, findings);
  SdfReading reading{file, finder_, caches_->meshes, caches_->shapes, findings, document.isSound()};
  Description description = describeFile(document, options_, Place(file.string()), reading);
  findings.throwErrors();
  description.notes = std::move(findings.notes);
  return description;
}

Model SdfLoader::loadModel(const std::string& uri, const std::string& name) {
  Description description = loadWorld(uri);
  if (description.models.size() != 1) {
    throw ErrorList({uri + ": has " + std::to_string(description.models.size()) +
                     " models; name a file with one model for '" + name + "'"});
  }
  Model model = std::move(description.models.front());
  model.name = name;
  for (const std::string& note : description.notes) model_notes_.push_back(name + ": " + note);
  return model;
}

Description loadWorld(const std::string& uri, const ResourceFinder& finder,
                      const SdfLoadOptions& options) {
  return SdfLoader(finder, options).loadWorld(uri);
}

Model loadModel(const std::string& uri, const std::string& name, const ResourceFinder& finder) {
  return SdfLoader(finder).loadModel(uri, name);
}

}  // namespace synthetic_dataset::world
