#include "world/sdf/sdf_picture_geometry.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/input_file.h"
#include "synthetic_dataset/errors.h"
#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

constexpr double kLargestSize = 1e7;  // [m]: points of larger things cannot be told apart

Outline readOutline(const Element& polyline, const Eigen::Vector3d& scale) {
  Outline outline;
  for (const Element& point : polyline.children("point")) {
    const std::vector<double> v = numbersIn(point.text());
    if (v.size() < 2 || !(std::abs(v[0]) <= kLargestSize) || !(std::abs(v[1]) <= kLargestSize)) {
      throw Error("polyline point: found '" + point.text() +
                  "'; it has to be two numbers, at most 1e7");
    }
    outline.emplace_back(v[0] * scale.x(), v[1] * scale.y());
  }
  return outline;
}

std::vector<GroundTexture> readTextures(const Element& heightmap, const SourceLocation& location,
                                        SdfReading& reading) {
  std::vector<GroundTexture> textures;
  for (const Element& each : heightmap.children("texture")) {
    GroundTexture texture;
    texture.diffuse = readText(each, "diffuse");
    texture.normal = readText(each, "normal");
    texture.size = requireSize("heightmap texture size",
                               readNumber(each, "size", texture.size, location, reading));
    if (!texture.diffuse.empty()) textures.push_back(texture);
  }
  return textures;
}

std::vector<GroundBlend> readBlends(const Element& heightmap, const SourceLocation& location,
                                    SdfReading& reading) {
  std::vector<GroundBlend> blends;
  for (const Element& each : heightmap.children("blend")) {
    blends.push_back({readNumber(each, "min_height", 0.0, location, reading),
                      readNumber(each, "fade_dist", 0.0, location, reading)});
  }
  return blends;
}

/// SDF 1.0 writes `filename`.
std::string uriOf(const Element& element) {
  return readText(element, element.value("uri") ? "uri" : "filename");
}

}  // namespace

double requireSize(const std::string& name, double value) {
  if (value > 0.0 && value <= kLargestSize) return value;
  throw Error(name + ": found " + shortText(value) + "; it has to be above 0 m" +
              (value > kLargestSize ? " and at most 1e7 m" : ""));
}

std::optional<std::filesystem::path> findFile(const std::string& kind, const std::string& uri,
                                              const Element& element,
                                              const SourceLocation& location, SdfReading& reading) {
  const std::filesystem::path folder = element.folder();
  auto file = reading.finder.find(uri, folder);
  if (!file) {
    reading.missing(location, kind + " '" + uri + "': no such file; " +
                                  reading.finder.searchedPlaces(uri, folder));
    return std::nullopt;
  }
  if (const std::string fault = base::inputFault(*file); !fault.empty()) {
    reading.missing(location, kind + " '" + file->string() + "': " + fault);
    return std::nullopt;
  }
  return file;
}

Extrusion readPolylines(const Element& geometry, const Eigen::Vector3d& scale,
                        const SourceLocation& location, SdfReading& reading) {
  Extrusion result;
  const std::vector<Element> polylines = geometry.children("polyline");
  const double height = readNumber(polylines.front(), "height", result.height, location, reading);
  result.height = requireSize("polyline height", height * scale.z());
  for (const Element& each : polylines) result.outlines.push_back(readOutline(each, scale));
  return result;
}

std::optional<Heightmap> readHeightmap(const Element& element, const Eigen::Vector3d& scale,
                                       const SourceLocation& location, SdfReading& reading) {
  Heightmap result;
  result.size = readVector(element, "size", result.size, location, reading).cwiseProduct(scale);
  requireSize("heightmap size", result.size.x());
  requireSize("heightmap size", result.size.y());
  if (!(std::abs(result.size.z()) <= kLargestSize)) {
    throw Error("heightmap size: found a height of " + shortText(result.size.z()) +
                "; it has to be at most 1e7 m");
  }
  result.centre = readVector(element, "pos", result.centre, location, reading);
  if (!(result.centre.cwiseAbs().maxCoeff() <= kLargestSize)) {
    throw Error("heightmap pos: it has to be at most 1e7 m away");
  }
  const double sampling = readNumber(element, "sampling", 1.0, location, reading);
  result.sampling = sampling >= 1.0 && sampling <= 1024.0 ? static_cast<unsigned>(sampling) : 1U;
  result.textures = readTextures(element, location, reading);
  result.blends = readBlends(element, location, reading);
  result.folder = element.folder();
  const auto file = findFile("heightmap", uriOf(element), element, location, reading);
  if (!file) return std::nullopt;
  result.file = *file;
  return result;
}

std::optional<WallMap> readWallMap(const Element& element, const SourceLocation& location,
                                   SdfReading& reading) {
  WallMap result;
  result.scale =
      requireSize("image scale", readNumber(element, "scale", result.scale, location, reading));
  result.height =
      requireSize("image height", readNumber(element, "height", result.height, location, reading));
  const double threshold = readNumber(element, "threshold", result.threshold, location, reading);
  result.threshold = static_cast<int>(std::clamp(threshold, 0.0, 255.0));
  const double granularity =
      readNumber(element, "granularity", result.granularity, location, reading);
  result.granularity = static_cast<int>(std::clamp(granularity, 1.0, 1e6));
  const auto file = findFile("image", uriOf(element), element, location, reading);
  if (!file) return std::nullopt;
  result.file = *file;
  return result;
}

}  // namespace synthetic_dataset::world
