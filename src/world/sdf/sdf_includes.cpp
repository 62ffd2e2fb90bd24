#include "world/sdf/sdf_includes.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <system_error>

#include "synthetic_dataset/errors.h"
#include "world/files/fuel.h"
#include "world/files/text.h"
#include "world/sdf/built_in_models.h"
#include "world/sdf/gz_plugins.h"
#include "world/sdf/model_config.h"

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

/// The name by which a URI means a model that needs no files, or an empty string.
std::string builtInName(const std::string& uri) {
  const std::string scheme = "model://";
  if (startsWith(uri, scheme)) {
    const std::string name = uri.substr(scheme.size());
    return percentDecoded(name.substr(0, name.find_last_not_of('/') + 1));
  }
  const std::optional<FuelUri> fuel = parseFuelUri(uri);
  return fuel && fuel->path.empty() ? fuel->name : "";
}

}  // namespace

ModelSource SdfIncludes::modelOf(const Element& model, const SourceLocation& outer) {
  ModelSource source;
  source.element = model;
  source.name = model.attribute("name");
  source.location = locationOf(model, outer);
  source.pose = readPose(model, source.location, reading_);
  source.placement_frame = model.attribute("placement_frame");
  source.is_static = readBool(model, "static", false, source.location, reading_);
  source.label = readLabel(model);
  for (const Element& child : model.children()) {
    if (child.name() == "model") source.models.push_back(modelOf(child, source.location));
    if (child.name() == "include") source.models.push_back(followed(child, source.location));
  }
  for (const ModelSource& inner : source.models) {
    source.has_gaps =
        source.has_gaps || inner.has_gaps || inner.kind == ModelSource::Kind::kNothing;
  }
  return source;
}

ModelSource SdfIncludes::followed(const Element& include, const SourceLocation& outer) {
  const SourceLocation location = outer.inFile(include.file().path.string());
  ModelSource source;
  source.kind = ModelSource::Kind::kNothing;
  source.element = include;
  source.location = location;
  const Element uri_element = include.child("uri");
  const Element& named = uri_element ? uri_element : include;
  const std::string uri = uri_element.text();
  const SourceLocation here = location.atLine(named.line());
  try {
    if (uri.empty()) throw Error("<include> has no <uri>");
    source = included(uri, include);
  } catch (const ErrorList&) {
    throw;
  } catch (const std::exception& error) {
    reading_.missing(here, (uri.empty() ? "" : "include '" + uri + "': ") + error.what());
  }
  applyOverrides(include, location, source);
  return source;
}

ModelSource SdfIncludes::included(const std::string& uri, const Element& include) {
  const SdfFile& file = fileOf(uri, include);
  const fs::path path = identity(file.path);
  if (std::find(chain_.begin(), chain_.end(), path) != chain_.end() ||
      path == identity(include.file().path)) {
    throw Error("includes itself, by way of " + std::to_string(chain_.size() + 1) + " file(s)");
  }
  if (chain_.size() >= kDeepestInclude) {
    throw Error(file.path.string() + ": included by files more than " +
                std::to_string(kDeepestInclude) + " deep");
  }
  if (++count_ > kMostIncludes) {
    throw ErrorList({include.file().path.string() + ": includes more than " +
                     std::to_string(kMostIncludes) + " files"});
  }
  chain_.push_back(path);
  ModelSource source = contentOf(file, SourceLocation(file.path.string()));
  chain_.pop_back();
  return source;
}

const SdfFile& SdfIncludes::fileOf(const std::string& uri, const Element& include) {
  const fs::path folder = include.folder();
  const std::optional<fs::path> found = reading_.finder.find(uri, folder);
  if (found) return reading_.files.read(fs::is_directory(*found) ? modelFileOf(*found) : *found);
  const std::string name = builtInName(uri);
  if (const auto text = builtInModel(name))
    return reading_.files.readText("/built-in/" + name, *text);
  throw Error("no such file; " + reading_.finder.searchedPlaces(uri, folder));
}

ModelSource SdfIncludes::contentOf(const SdfFile& file, const SourceLocation& location) {
  const Element root(&file.root(), &file);
  reading_.is_of_gz |= file.is_of_gz;
  ModelSource source;
  source.element = root;
  source.location = location;
  if (file.is_urdf) {
    source.kind = ModelSource::Kind::kUrdf;
    source.name = root.attribute("name");
    return source;
  }
  for (const Element& child : root.children()) {
    if (child.name() == "model") return modelOf(child, location);
    if (child.name() != "light" && child.name() != "actor") continue;
    source.kind = child.name() == "light" ? ModelSource::Kind::kLight : ModelSource::Kind::kActor;
    source.element = child;
    source.name = child.attribute("name");
    source.location = locationOf(child, location);
    source.pose = readPose(child, source.location, reading_);
    return source;
  }
  throw Error(file.path.string() + ": holds no model, light or actor");
}

void SdfIncludes::applyOverrides(const Element& include, const SourceLocation& location,
                                 ModelSource& source) const {
  const std::string name = readText(include, "name");
  if (!name.empty()) source.name = name;
  if (hasPose(include)) {
    source.pose = readPose(include, location, reading_);
    source.placement_frame.clear();
  }
  const std::string frame = readText(include, "placement_frame");
  if (!frame.empty()) source.placement_frame = frame;
  source.is_static = readBool(include, "static", source.is_static, location, reading_);
  if (const auto label = readLabel(include)) source.label = label;
  source.merges = include.attribute("merge") == "true" || include.attribute("merge") == "1";
}

}  // namespace synthetic_dataset::world
