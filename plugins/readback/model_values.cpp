#include "plugins/readback/model_values.h"

#include <algorithm>
#include <vector>

#include "plugins/readback/files.h"

namespace synthetic_dataset::formats {
namespace {

/// A line of a PLY file: numbers, the last `whole` of which are whole ones.
void compareLine(const std::vector<std::string>& found, const std::vector<double>& right,
                 const std::filesystem::path& file, const std::string& where,
                 Differences& differences) {
  if (found.size() != right.size()) {
    differences.add(where, std::to_string(found.size()) + " numbers", std::to_string(right.size()));
    return;
  }
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (areNear(numberOf(found[i], file), right[i])) continue;
    differences.add(where, found[i], std::to_string(right[i]));
  }
}

std::string headerOf(const ObjectModel& model) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex ";
  text += std::to_string(model.vertices.size()) + "\n";
  for (const std::string name : {"x", "y", "z", "nx", "ny", "nz"}) {
    text += "property float " + name + "\n";
  }
  for (const std::string name : {"red", "green", "blue"}) text += "property uchar " + name + "\n";
  return text + "element face " + std::to_string(model.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

}  // namespace

void comparePly(const std::string& name, const ObjectModel& model, double scale,
                FoundFiles& files) {
  const auto file = files.take(name);
  if (!file) return;
  const std::string text = readText(*file);
  const std::string header = headerOf(model);
  if (text.compare(0, header.size(), header) != 0) {
    files.differences().add(name + ": its header is not that of " +
                            std::to_string(model.vertices.size()) + " vertices and " +
                            std::to_string(model.triangles.size()) + " triangles");
    return;
  }
  const std::vector<std::string> lines = readLines(*file);
  const auto header_lines =
      static_cast<std::size_t>(std::count(header.begin(), header.end(), '\n'));
  const std::size_t vertices = model.vertices.size();
  const std::size_t right_lines = header_lines + vertices + model.triangles.size();
  if (lines.size() != right_lines) {
    files.differences().add(name, std::to_string(lines.size()) + " lines",
                            std::to_string(right_lines));
    return;
  }
  for (std::size_t i = header_lines; i < lines.size(); ++i) {
    const std::size_t k = i - header_lines;
    std::vector<double> right;
    if (k < vertices) {
      const ObjectModel::Vertex& vertex = model.vertices[k];
      const Eigen::Vector3d p = scale * vertex.position;
      right = {p.x(), p.y(), p.z(), vertex.normal.x(), vertex.normal.y(), vertex.normal.z()};
      for (const std::uint8_t each : vertex.colour) right.push_back(each);
    } else {
      right = {3.0};
      for (const std::int32_t corner : model.triangles[k - vertices]) right.push_back(corner);
    }
    compareLine(wordsOf(lines[i]), right, *file, name + ", line " + std::to_string(i + 1),
                files.differences());
  }
}

Cuboid extentOf(const ObjectModel& model) {
  Cuboid extent{model.vertices.front().position, model.vertices.front().position};
  for (const ObjectModel::Vertex& vertex : model.vertices) {
    extent.low = extent.low.cwiseMin(vertex.position);
    extent.high = extent.high.cwiseMax(vertex.position);
  }
  return extent;
}

}  // namespace synthetic_dataset::formats
