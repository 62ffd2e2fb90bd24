#include "world/world_loader.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "synthetic_dataset/errors.h"
#include "world/files/findings.h"
#include "world/mesh/mesh_loader.h"
#include "world/sdf/element.h"
#include "world/sdf/model_config.h"
#include "world/sdf/sdf_file.h"
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

/// The file to which a URI given by the user refers.
fs::path fileFor(const std::string& uri, const ResourceFinder& finder) {
  std::error_code gone;  // the working folder may be gone; absolute names do not need it
  const fs::path here = fs::current_path(gone);
  const std::optional<fs::path> found = finder.find(uri, here);
  if (!found) {
    const std::string searched = finder.searchedPlaces(uri, here);
    const std::string itself = "looked in " + uri;
    const bool says_more = searched.compare(0, itself.size(), itself) != 0;
    throw ErrorList({"'" + uri + "': no such file" +
                     (says_more ? "; " + searched : searched.substr(itself.size()))});
  }
  try {
    return fs::is_directory(*found) ? modelFileOf(*found) : *found;
  } catch (const std::exception& error) {
    throw ErrorList({uri + ": " + error.what()});
  }
}

/// A file that cannot be parsed is the only error then.
template <class Read>
const SdfFile& parsedFile(const Read& read) {
  try {
    return read();
  } catch (const ErrorList&) {
    throw;
  } catch (const Error& error) {
    throw ErrorList({error.what()});
  }
}

/// The name of a template with its arguments, as of a file next to it: one name for each expanded
/// text.
fs::path expandedName(const fs::path& file, const TemplateArguments& arguments) {
  std::string name = file.filename().string();
  for (const auto& [key, value] : arguments) name += " " + key + ":=" + value;
  std::replace(name.begin(), name.end(), '/', '|');
  return file.parent_path() / name;
}

Description describeUrdf(const SdfFile& file, SdfReading& reading) {
  Description description;
  if (reading.survey != nullptr) return description;  // a URDF is read without a survey
  UrdfModel robot = readUrdfModel(file, reading);
  description.models.push_back(std::move(robot.model));
  description.cameras = std::move(robot.cameras);
  description.lidars = std::move(robot.lidars);
  return description;
}

Description describe(const SdfFile& file, SdfReading& reading) {
  const Element root(&file.root(), &file);
  const SourceLocation location(file.path.string());
  reading.is_of_gz |= file.is_of_gz;
  if (file.odd) reading.findings.addNote(file.path.string() + ": " + *file.odd);
  if (file.is_urdf) return describeUrdf(file, reading);
  if (const Element world = root.child("world")) return readWorld(world, reading);
  if (root.has("model") || root.has("light") || root.has("actor") || root.has("include"))
    return readWorld(root, reading);
  reading.findings.addError(location.message("holds neither a world nor a model nor a light"));
  return {};
}

}  // namespace

struct WorldLoader::Caches {
  explicit Caches(const ResourceFinder& finder) : meshes(finder) {}

  MeshLoader meshes;
  ShapeCache shapes;
  SdfFiles sdf_files;
  std::map<fs::path, std::string> expanded;  ///< by `expandedName`
};

WorldLoader::WorldLoader(const ResourceFinder& finder, const LoadOptions& options,
                         base::OnStage on_stage)
    : finder_(finder),
      options_(options),
      on_stage_(std::move(on_stage)),
      caches_(std::make_unique<Caches>(finder)) {}

WorldLoader::~WorldLoader() = default;

Description WorldLoader::loadWorld(const std::string& uri) { return loadFile(uri, {}); }

Description WorldLoader::loadFile(const std::string& uri, const TemplateArguments& arguments) {
  const fs::path file = fileFor(uri, finder_);
  on_stage_("reading '" + uri + "'");
  const SdfFile& parsed = parsedFile([&]() -> const SdfFile& {
    if (!isTemplate(file)) return caches_->sdf_files.read(file);
    const fs::path name = expandedName(file, arguments);
    auto text = caches_->expanded.find(name);
    if (text == caches_->expanded.end()) {
      text = caches_->expanded.emplace(name, expandTemplate(file, arguments)).first;
    }
    return caches_->sdf_files.readText(name, text->second);
  });
  return load(parsed);
}

/// Missing files are found first, before anything large is read; then all meshes and pictures are
/// read in parallel.
Description WorldLoader::load(const SdfFile& file) {
  Findings findings;
  findings.on_missing_asset = options_.on_missing_asset;
  SdfReading reading{finder_,  caches_->meshes, caches_->shapes, caches_->sdf_files,
                     findings, readUrdfModel};
  SdfSurvey survey;
  reading.survey = &survey;
  static_cast<void>(describe(file, reading));
  findings.throwErrors();
  const std::string of_file = " of '" + file.path.string() + "'";
  on_stage_("reading the meshes" + of_file);
  caches_->meshes.readAhead(survey.meshes);
  on_stage_("decoding the pictures" + of_file);
  caches_->meshes.textures().decodeAhead(survey.pictures);
  reading.survey = nullptr;
  Description description = describe(file, reading);
  description.simulator =
      options_.simulator.value_or(reading.is_of_gz ? Simulator::kGz : Simulator::kClassic);
  for (const std::string& note : caches_->meshes.takeNotes()) findings.addNote(note);
  findings.throwErrors();
  description.notes = std::move(findings.notes);
  return description;
}

Description WorldLoader::loadText(const std::string& text, const std::string& name) {
  const SdfFile& parsed =
      parsedFile([&]() -> const SdfFile& { return caches_->sdf_files.readText(name, text); });
  try {
    return load(parsed);
  } catch (const ErrorList& errors) {
    std::vector<std::string> messages = errors.messages();
    for (std::string& message : messages) {
      if (message.find("no such file") == std::string::npos) continue;
      message += "; a text without a file can name only package://, model:// and absolute paths";
    }
    throw ErrorList(std::move(messages));
  }
}

Model WorldLoader::loadModel(const std::string& model_or_uri, const std::string& name,
                             const TemplateArguments& arguments) {
  const bool is_text = isModelText(model_or_uri);
  const std::string source = is_text ? "the text of " + name + "/model" : model_or_uri;
  Description description =
      is_text ? loadText(model_or_uri, source) : loadFile(model_or_uri, arguments);
  if (description.models.size() != 1) {
    throw ErrorList({source + ": has " + std::to_string(description.models.size()) +
                     " models; name a file with one model for '" + name + "'"});
  }
  Model model = std::move(description.models.front());
  model.name = name;
  for (const std::string& note : description.notes) model_notes_.push_back(name + ": " + note);
  const auto keep = [&name](auto& sensors, auto& all) {
    for (auto& sensor : sensors) {
      sensor.name = name + sensor.name.substr(sensor.name.find("::"));
      all.push_back(std::move(sensor));
    }
  };
  keep(description.cameras, model_cameras_);
  keep(description.lidars, model_lidars_);
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
