#include "world/sdf/sdf_element_geometry.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::world {
namespace {

constexpr double kLargestSize = 1e7;  // [m]: there is no telling points of larger things apart

std::string textOf(const sdf::ElementPtr& parent, const char* name) {
  const sdf::ElementPtr element = descendant(parent, {name});
  return element ? element->Get<std::string>() : "";
}

/// A number of any size: "1e+300".
std::string shortText(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// Three numbers, or the fallback where the file has none.
Eigen::Vector3d vectorOf(const sdf::ElementPtr& parent, const char* name,
                         const Eigen::Vector3d& fallback, const Place& place, SdfReading& reading) {
  const sdf::ElementPtr element = descendant(parent, {name});
  if (!element) return fallback;
  const std::vector<double> values = numbers(element);
  if (values.size() == 3) {
    const Eigen::Vector3d vector(values[0], values[1], values[2]);
    if (vector.allFinite() && vector.cwiseAbs().maxCoeff() <= kLargestSize) return vector;
  }
  reading.findings.addError(place.message(std::string(name) + ": found '" + textOf(parent, name) +
                                          "'; it has to be three numbers, at most 1e7"));
  return fallback;
}

Outline readOutline(const sdf::ElementPtr& polyline, const Place& place, SdfReading& reading) {
  Outline outline;
  if (!has(polyline, "point")) return outline;
  for (auto point = polyline->GetElement("point"); point; point = point->GetNextElement("point")) {
    const std::vector<double> values = numbers(point);
    const bool good = values.size() == 2 && std::abs(values[0]) <= kLargestSize &&
                      std::abs(values[1]) <= kLargestSize;
    if (good) {
      outline.emplace_back(values[0], values[1]);
    } else {
      reading.findings.addError(place.message("polyline point: found '" +
                                              point->Get<std::string>() +
                                              "'; it has to be two numbers, at most 1e7"));
    }
  }
  return outline;
}

std::vector<GroundTexture> readTextures(const sdf::ElementPtr& heightmap, const Place& place,
                                        SdfReading& reading) {
  std::vector<GroundTexture> textures;
  if (!has(heightmap, "texture")) return textures;
  for (auto each = heightmap->GetElement("texture"); each; each = each->GetNextElement("texture")) {
    GroundTexture texture;
    texture.diffuse = textOf(each, "diffuse");
    texture.normal = textOf(each, "normal");
    texture.size =
        readSize("heightmap texture size", number(each, {"size"}, texture.size), place, reading);
    // libsdformat writes "__default__" where a file leaves an URI out.
    if (texture.normal == "__default__") texture.normal.clear();
    if (!texture.diffuse.empty() && texture.diffuse != "__default__") textures.push_back(texture);
  }
  return textures;
}

std::vector<GroundBlend> readBlends(const sdf::ElementPtr& heightmap) {
  std::vector<GroundBlend> blends;
  if (!has(heightmap, "blend")) return blends;
  for (auto each = heightmap->GetElement("blend"); each; each = each->GetNextElement("blend")) {
    blends.push_back({number(each, {"min_height"}, 0.0), number(each, {"fade_dist"}, 0.0)});
  }
  return blends;
}

}  // namespace

double readSize(const std::string& name, double value, const Place& place, SdfReading& reading) {
  if (value > 0.0 && value <= kLargestSize) return value;
  reading.findings.addError(place.message(
      name + ": found " + (std::abs(value) <= kLargestSize ? fixed(value, 6) : shortText(value)) +
      "; it has to be above 0 m" + (value > kLargestSize ? " and at most 1e7 m" : "")));
  return 1.0;
}

std::optional<std::filesystem::path> readFile(const std::string& kind, const std::string& uri,
                                              const sdf::ElementPtr& element, const Place& place,
                                              SdfReading& reading) {
  const std::filesystem::path folder = reading.folderOf(element);
  auto file = reading.finder.find(uri, folder);
  if (!file) {
    reading.missing(place.message(kind + " '" + uri + "': no such file; " +
                                  reading.finder.searchedPlaces(uri, folder)));
    return std::nullopt;
  }
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(*file, ignored)) {
    reading.missing(place.message(kind + " '" + file->string() + "': is a folder or no file"));
    return std::nullopt;
  }
  return file;
}

std::optional<Extrusion> readPolylines(const sdf::ElementPtr& geometry, const Place& place,
                                       SdfReading& reading) {
  Extrusion result;
  const sdf::ElementPtr first = geometry->GetElement("polyline");
  result.height =
      readSize("polyline height", number(first, {"height"}, result.height), place, reading);
  for (auto each = first; each; each = each->GetNextElement("polyline")) {
    result.outlines.push_back(readOutline(each, place, reading));
  }
  return result;
}

std::optional<Heightmap> readHeightmap(const sdf::ElementPtr& element, const Place& place,
                                       SdfReading& reading) {
  Heightmap result;
  result.size = vectorOf(element, "size", result.size, place, reading);
  for (const int axis : {0, 1}) {
    result.size[axis] = readSize("heightmap size", result.size[axis], place, reading);
  }
  result.centre = vectorOf(element, "pos", result.centre, place, reading);
  const double sampling = number(element, {"sampling"}, 1.0);
  result.sampling = sampling >= 1.0 && sampling <= 1024.0 ? static_cast<unsigned>(sampling) : 1U;
  result.textures = readTextures(element, place, reading);
  result.blends = readBlends(element);
  result.folder = reading.folderOf(element);
  const auto file = readFile("heightmap", textOf(element, "uri"), element, place, reading);
  if (!file) return std::nullopt;
  result.file = *file;
  return result;
}

std::optional<WallMap> readWallMap(const sdf::ElementPtr& element, const Place& place,
                                   SdfReading& reading) {
  WallMap result;
  result.scale = readSize("image scale", number(element, {"scale"}, result.scale), place, reading);
  result.height =
      readSize("image height", number(element, {"height"}, result.height), place, reading);
  const double threshold = number(element, {"threshold"}, result.threshold);
  result.threshold = static_cast<int>(std::clamp(threshold, 0.0, 255.0));
  const double granularity = number(element, {"granularity"}, result.granularity);
  result.granularity = static_cast<int>(std::clamp(granularity, 1.0, 1e6));
  const auto file = readFile("image", textOf(element, "uri"), element, place, reading);
  if (!file) return std::nullopt;
  result.file = *file;
  return result;
}

}  // namespace synthetic_dataset::world
