#include "world/sdf/include_graph.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include <sdf/sdf_config.h>
#include <tinyxml2.h>

#include "synthetic_dataset/errors.h"
#include "world/files/fuel.h"
#include "world/files/gz_plugins.h"
#include "world/files/text.h"
#include "world/sdf/built_in_models.h"
#include "world/sdf/joined_models.h"
#include "world/sdf/model_config.h"
#include "world/sdf/sdf_document.h"
#include "world/sdf/stand_in_model.h"
#include "world/sdf/xml_text.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

/// More is taken for files that multiply one another.
constexpr std::size_t kMostIncludes = 20000;
constexpr std::size_t kDeepestInclude = 30;

/// The one path of a file that may have several.
fs::path identity(const fs::path& file) {
  std::error_code error;
  const fs::path result = fs::canonical(file, error);
  return error ? file : result;
}

/// Opening anything else may wait for ever.
void requireFile(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_regular_file(file, ignored)) return;
  throw Error(file.string() + ": is " + (fs::is_directory(file, ignored) ? "a folder" : "no file") +
              "; a file is needed");
}

/// Why a document is no world or model, or nothing.
std::optional<std::string> faultOf(const tinyxml2::XMLDocument& document) {
  if (document.Error()) {
    return "line " + std::to_string(document.ErrorLineNum()) + ": cannot be read as XML (" +
           document.ErrorName() + ")";
  }
  const tinyxml2::XMLElement* root = document.RootElement();
  const std::string name = root != nullptr ? root->Name() : "";
  if (name == "robot") return std::nullopt;
  if (name == "sdf" || name == "gazebo") {
    const char* version = root->Attribute("version");
    if (version != nullptr && isSdfVersion(version)) return std::nullopt;
    const std::string found =
        version == nullptr ? "> has no version; "
                           : "> has the version '" + std::string(version) + "', which is none; ";
    return "line " + std::to_string(root->GetLineNum()) + ": <" + name + found +
           "the one that the file is written for is needed, as in version='1.6'";
  }
  return "its root element is <" + name + ">; <sdf> is needed, or <robot> of a URDF file";
}

std::string attributeOf(const tinyxml2::XMLElement& element, const char* name) {
  const char* const text = element.Attribute(name);
  return text == nullptr ? "" : text;
}

/// What has no part in a picture, and often things in it that libsdformat refuses.
bool isIrrelevant(const std::string& name) {
  return name == "plugin" || name == "gui" || name == "audio" || name == "audio_source" ||
         name == "audio_sink" || name.find(':') != std::string::npos;
}

/// The name by which a URI means a model that needs no files, or an empty string.
std::string builtInName(const std::string& uri) {
  const std::string scheme = "model://";
  if (uri.rfind(scheme, 0) == 0) {
    const std::string name = uri.substr(scheme.size());
    return percentDecoded(name.substr(0, name.find_last_not_of('/') + 1));
  }
  const std::optional<FuelUri> fuel = parseFuelUri(uri);
  return fuel && fuel->path.empty() ? fuel->name : "";
}

fs::path builtInFile(const std::string& name) { return "/built-in/" + name + ".sdf"; }

/// The root as the library knows it. Old files call it <gazebo>. Newer ones than the library are
/// given its version: what they add is foreign to it, which it tolerates.
void adaptRoot(tinyxml2::XMLElement& root) {
  root.SetName("sdf");
  if (parseSdfVersion(root.Attribute("version")) > newestSdfVersion()) {
    root.SetAttribute("version", SDF_VERSION);
  }
}

}  // namespace

IncludeGraph::IncludeGraph(const fs::path& file, const ResourceFinder& finder, Findings& findings,
                           std::optional<std::string> text)
    : finder_(finder), findings_(findings), text_(std::move(text)) {
  try {
    prepared_file_ = prepare(file).path;
    join(file);
  } catch (const Error& error) {
    findings_.addError(error.what());
  }
}

const IncludeGraph::Prepared& IncludeGraph::prepare(const fs::path& file) {
  auto known = files_.find(file.string());
  if (known == files_.end()) {
    Prepared prepared;
    try {
      prepared = read(file);
    } catch (const Error& error) {
      prepared.fault = error.what();
    }
    known = files_.emplace(file.string(), std::move(prepared)).first;
  }
  if (!known->second.fault.empty()) throw Error(known->second.fault);
  return known->second;
}

IncludeGraph::Prepared IncludeGraph::read(const fs::path& file) {
  const bool is_text = text_ && chain_.empty();
  if (!is_text) requireFile(file);
  const auto document = std::make_shared<tinyxml2::XMLDocument>();
  if (is_text) {
    document->Parse(text_->c_str(), text_->size());
  } else {
    document->LoadFile(file.c_str());
  }
  if (const auto reason = faultOf(*document)) throw Error(file.string() + ": " + *reason);
  tinyxml2::XMLElement& root = *document->RootElement();
  Prepared result;
  if (std::string(root.Name()) == "robot") {
    result.path = file;
    return result;
  }
  if (chain_.size() >= kDeepestInclude) {
    throw Error(file.string() + ": included by files more than " + std::to_string(kDeepestInclude) +
                " deep");
  }
  chain_.push_back(identity(file));
  adapt(root, file, result);
  chain_.pop_back();
  too_many_ = too_many_ || result.includes > kMostIncludes;
  if (too_many_) {
    throw Error(file.string() + ": includes more than " + std::to_string(kMostIncludes) + " files");
  }
  adaptRoot(root);
  const tinyxml2::XMLElement* world = root.FirstChildElement("world");  // the only one that is read
  for (MentionedMesh& each : mentionedMeshes(world ? *world : root, file.parent_path())) {
    meshes_.push_back(std::move(each));
  }
  copies_.write(file, root);
  result.path = copies_.copyOf(file);
  result.content = document;
  if (!chain_.empty()) requireLoadable(file, result);
  return result;
}

IncludeGraph::Prepared IncludeGraph::readBuiltIn(const std::string& name, const std::string& text) {
  const auto document = std::make_shared<tinyxml2::XMLDocument>();
  document->Parse(text.c_str());
  const fs::path file = builtInFile(name);
  copies_.write(file, *document->RootElement());
  return {copies_.copyOf(file), 0, "", document};
}

void IncludeGraph::join(const fs::path& file) {
  const Prepared& prepared = files_.at(file.string());
  if (!prepared.content) return;
  tinyxml2::XMLElement& root = *prepared.content->RootElement();
  const auto included = [this](const fs::path& copy) -> IncludedFile {
    const std::string original = originalOf(copy.string());
    const auto found = files_.find(original);
    const bool is_known = found != files_.end() && found->second.content;
    return {is_known ? found->second.content->RootElement() : nullptr, original};
  };
  if (!joinModels(root, included)) return;
  joined_copies_ = std::make_unique<SdfCopies>();
  joined_copies_->write(file, root);
  joined_file_ = joined_copies_->copyOf(file);
}

/// Where a faulty file costs no more than itself, libsdformat tries each alone.
void IncludeGraph::requireLoadable(const fs::path& file, const Prepared& prepared) const {
  if (findings_.on_missing_asset == OnMissingAsset::kError) return;
  Findings trial;
  const SdfDocument document(file, prepared.path, copies_, trial);
  if (!trial.errors.empty()) throw Error(trial.errors.front());
}

void IncludeGraph::adapt(tinyxml2::XMLElement& parent, const fs::path& file, Prepared& result) {
  std::vector<tinyxml2::XMLElement*> missing;
  tinyxml2::XMLElement* next = nullptr;
  for (auto* child = parent.FirstChildElement(); child != nullptr; child = next) {
    next = child->NextSiblingElement();
    const std::string name = child->Name();
    if (isIrrelevant(name)) {
      is_of_gz_ |= name == "plugin" &&
                   isPluginOfGz(attributeOf(*child, "filename"), attributeOf(*child, "name"));
      parent.DeleteChild(child);
    } else if (name != "include") {
      adapt(*child, file, result);
    } else if (!resolveInclude(*child, file, result)) {
      missing.push_back(child);
    }
  }
  for (tinyxml2::XMLElement* include : missing) replaceByStandIn(*include);
}

bool IncludeGraph::resolveInclude(tinyxml2::XMLElement& include, const fs::path& file,
                                  Prepared& result) {
  tinyxml2::XMLElement* uri = include.FirstChildElement("uri");
  const tinyxml2::XMLElement& named = uri != nullptr ? *uri : include;
  const std::string place = file.string() + ": line " + std::to_string(named.GetLineNum()) + ": ";
  const std::string text = trimmed(textOf(uri));
  if (text.empty()) {
    findings_.addMissing(place + "<include> has no <uri>");
    return false;
  }
  const Prepared* included = prepareInclude(text, file, place + "include '" + text + "': ");
  if (included == nullptr) return false;
  result.includes = std::min(kMostIncludes + 1, result.includes + included->includes + 1);
  uri->DeleteChildren();  // comments, which SetText leaves
  uri->SetText(included->path.c_str());
  while (auto* plugin = include.FirstChildElement("plugin")) include.DeleteChild(plugin);
  return true;
}

const IncludeGraph::Prepared* IncludeGraph::prepareInclude(const std::string& uri,
                                                           const fs::path& file,
                                                           const std::string& place) {
  const fs::path folder = file.parent_path();
  const std::optional<fs::path> found = finder_.find(uri, folder);
  if (!found) {
    const std::string name = builtInName(uri);
    if (const auto text = builtInModel(name)) {
      return &files_.emplace(builtInFile(name).string(), readBuiltIn(name, *text)).first->second;
    }
    if (reported_.emplace(file.string(), uri).second) {
      findings_.addMissing(place + "no such file; " + finder_.searchedPlaces(uri, folder));
    }
    return nullptr;
  }
  try {
    const fs::path model = fs::is_directory(*found) ? modelFileOf(*found) : *found;
    if (std::find(chain_.begin(), chain_.end(), identity(model)) != chain_.end()) {
      throw Error("includes itself, by way of " + std::to_string(chain_.size()) + " file(s)");
    }
    return &prepare(model);
  } catch (const std::exception& error) {
    findings_.addMissing(place + error.what());
    return nullptr;
  }
}

}  // namespace synthetic_dataset::world
