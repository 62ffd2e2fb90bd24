#include "world/world_loader.h"

#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "synthetic_dataset/errors.h"
#include "world/files/findings.h"
#include "world/mesh/mesh_loader.h"
#include "world/reading_ahead.h"
#include "world/sdf/include_graph.h"
#include "world/sdf/model_config.h"
#include "world/sdf/sdf_document.h"
#include "world/sdf/sdf_lights.h"
#include "world/sdf/sdf_models.h"
#include "world/sdf/sdf_reading.h"
#include "world/sdf/sdf_worlds.h"
#include "world/shape/shape_cache.h"
#include "world/urdf/urdf_models.h"

namespace synthetic_dataset::world {

bool isModelText(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && text[first] == '<';
}

namespace {

namespace fs = std::filesystem;

/// The file that a URI of the user's means.
fs::path fileFor(const std::string& uri, const ResourceFinder& finder) {
  std::error_code gone;  // the working folder may be, and absolute names do without
  const fs::path here = fs::current_path(gone);
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

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The pose of what stands alone in its file, which libsdformat cannot always resolve.
Pose lonePose(const sdf::SemanticPose& pose) {
  auto resolved = pose.RawPose();
  const bool known = pose.Resolve(resolved).empty();
  return toPose(known ? resolved : pose.RawPose());
}

Description describeFile(const SdfDocument& document, const Place& place, SdfReading& reading) {
  Description description;
  if (document.world() != nullptr) {
    readWorld(*document.world(), place, reading, description);
  } else if (document.model() != nullptr) {
    const sdf::Model& model = *document.model();
    ModelContents contents = readModel(model, lonePose(model.SemanticPose()), place, reading);
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

/// What the quicker way finds wrong, the other one tells in the right words.
std::unique_ptr<SdfDocument> readDocument(const fs::path& file, const IncludeGraph& includes,
                                          Findings& findings) {
  const SdfCopies& copies = includes.copies();
  if (!includes.joinedFile().empty()) {
    Findings trial;
    auto document = std::make_unique<SdfDocument>(file, includes.joinedFile(), copies, trial);
    if (document->isSound()) return document;
  }
  return std::make_unique<SdfDocument>(file, includes.preparedFile(), copies, findings);
}

}  // namespace

struct WorldLoader::Caches {
  explicit Caches(const ResourceFinder& finder) : meshes(finder) {}

  MeshLoader meshes;
  ShapeCache shapes;
};

WorldLoader::WorldLoader(const ResourceFinder& finder, const LoadOptions& options)
    : finder_(finder), options_(options), caches_(std::make_unique<Caches>(finder)) {}

WorldLoader::~WorldLoader() = default;

Description WorldLoader::loadWorld(const std::string& uri) {
  const fs::path file = fileFor(uri, finder_);
  const std::string text = contentOf(file);
  return isUrdf(text) ? loadUrdf({file.string(), file.parent_path(), text})
                      : loadSdf(file, std::nullopt);
}

Description WorldLoader::loadUrdf(const ModelText& source) {
  Findings findings;
  findings.on_missing_asset = options_.on_missing_asset;
  UrdfReading reading{source, finder_, caches_->meshes, caches_->shapes, findings};
  Description description;
  description.simulator = options_.simulator.value_or(Simulator::kClassic);
  description.models.push_back(readUrdfModel(reading));
  findings.throwErrors();
  description.notes = std::move(findings.notes);
  return description;
}

Description WorldLoader::loadSdf(const fs::path& file, const std::optional<std::string>& text) {
  Findings findings;
  findings.on_missing_asset = options_.on_missing_asset;
  const IncludeGraph includes(file, finder_, findings, text);
  if (!includes.isReadable()) findings.throwErrors();
  ReadingAhead ahead(includes.meshes(), finder_, caches_->meshes);
  const auto document = readDocument(file, includes, findings);
  ahead.finish();
  SdfReading reading{
      file, finder_, caches_->meshes, caches_->shapes, findings, document->isSound()};
  Description description = describeFile(*document, Place(file.string()), reading);
  const Simulator told =
      reading.is_of_gz || includes.isOfGz() ? Simulator::kGz : Simulator::kClassic;
  description.simulator = options_.simulator.value_or(told);
  findings.throwErrors();
  description.notes = std::move(findings.notes);
  return description;
}

Description WorldLoader::loadText(const std::string& text, const std::string& name) {
  if (isUrdf(text)) return loadUrdf({name, std::nullopt, text});
  try {
    return loadSdf(name, text);
  } catch (const ErrorList& errors) {
    std::vector<std::string> messages = errors.messages();
    for (std::string& message : messages) {
      if (message.find("no such file") == std::string::npos) continue;
      message +=
          "; from a text that is in no file, package://, model:// and absolute paths lead on";
    }
    throw ErrorList(std::move(messages));
  }
}

Model WorldLoader::loadModel(const std::string& model_or_uri, const std::string& name) {
  const bool is_text = isModelText(model_or_uri);
  const std::string source = is_text ? "the text of " + name + "/model" : model_or_uri;
  Description description = is_text ? loadText(model_or_uri, source) : loadWorld(model_or_uri);
  if (description.models.size() != 1) {
    throw ErrorList({source + ": has " + std::to_string(description.models.size()) +
                     " models; name a file with one model for '" + name + "'"});
  }
  Model model = std::move(description.models.front());
  model.name = name;
  for (const std::string& note : description.notes) model_notes_.push_back(name + ": " + note);
  for (CameraSensor& camera : description.cameras) {
    camera.name = name + camera.name.substr(camera.name.find("::"));
    model_cameras_.push_back(std::move(camera));
  }
  return model;
}

Description loadWorld(const std::string& uri, const ResourceFinder& finder,
                      const LoadOptions& options) {
  return WorldLoader(finder, options).loadWorld(uri);
}

Model loadModel(const std::string& uri, const std::string& name, const ResourceFinder& finder) {
  return WorldLoader(finder).loadModel(uri, name);
}

}  // namespace synthetic_dataset::world
