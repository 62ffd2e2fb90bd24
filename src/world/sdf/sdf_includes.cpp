#include "world/sdf/sdf_includes.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <optional>
#include <string>
#include <system_error>

#include "synthetic_dataset/errors.h"
#include "world/files/fuel.h"
#include "world/files/text.h"
#include "world/sdf/gz_plugins.h"
#include "world/sdf/model_config.h"

namespace synthetic_dataset::world {
namespace {

constexpr const char* kGroundPlane = R"(<sdf version="1.6"><model name="ground_plane">
<static>true</static>
<link name="link">
  <collision name="collision">
    <geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry>
    <surface><friction><ode><mu>100</mu><mu2>50</mu2></ode></friction></surface>
  </collision>
  <visual name="visual">
    <cast_shadows>false</cast_shadows>
    <geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry>
    <material>
      <ambient>0.3 0.3 0.3 1</ambient>
      <diffuse>0.7 0.7 0.7 1</diffuse>
      <specular>0.01 0.01 0.01 1</specular>
    </material>
  </visual>
</link>
</model></sdf>)";

constexpr const char* kSun = R"(<sdf version="1.6"><light name="sun" type="directional">
<cast_shadows>true</cast_shadows>
<pose>0 0 10 0 0 0</pose>
<diffuse>0.8 0.8 0.8 1</diffuse>
<specular>0.2 0.2 0.2 1</specular>
<attenuation>
  <range>1000</range><constant>0.9</constant><linear>0.01</linear><quadratic>0.001</quadratic>
</attenuation>
<direction>-0.5 0.1 -0.9</direction>
</light></sdf>)";

/// The models that nearly every world includes and that need no files: the plane "ground_plane" and
/// the light "sun", with the sizes and colours of Gazebo's.
/// @param name  as in a URI; "Ground Plane" and "ground_plane" are the same
/// @return an SDF file's text, or nothing for any other name
std::optional<std::string> builtInModel(const std::string& name) {
  std::string plain;
  for (const char c : name) {
    plain += c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  if (plain == "ground_plane") return kGroundPlane;
  if (plain == "sun") return kSun;
  return std::nullopt;
}

namespace fs = std::filesystem;

/// Anything beyond these limits is taken for files that multiply one another.
constexpr std::size_t kMostIncludes = 20000;
constexpr std::size_t kDeepestInclude = 30;

/// The canonical path of a file, which several paths may lead to.
fs::path identity(const fs::path& file) {
  std::error_code error;
  const fs::path result = fs::canonical(file, error);
  return error ? file : result;
}

/// The name of the built-in model that a URI may refer to, or an empty string.
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
