#include <iomanip>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>

#include "synthetic_dataset/object_model.h"

namespace synthetic_dataset {
inline namespace v2 {
namespace {

/// A number for the file's `float` properties, with the fewest digits that read back as the same
/// float: from 6, printed without trailing zeros, to 9, with which every float survives.
std::string floatText(double number) {
  constexpr int kFewestDigits = 6;
  constexpr int kMostDigits = 9;
  const float value = static_cast<float>(number) + 0.0F;  // no "-0"
  // std::to_chars does not support floating-point numbers before GCC 11.
  std::stringstream text;
  text.imbue(std::locale::classic());
  for (int digits = kFewestDigits;; ++digits) {
    text.clear();
    text.str({});
    text << std::setprecision(digits) << value;
    float read = 0.0F;
    if (digits == kMostDigits || (text >> read && read == value)) return text.str();
  }
}

std::string vectorText(const Eigen::Vector3d& vector) {
  return floatText(vector.x()) + " " + floatText(vector.y()) + " " + floatText(vector.z()) + " ";
}

std::string header(const ObjectModel& model) {
  std::string text = "ply\nformat ascii 1.0\n";
  text += "element vertex " + std::to_string(model.vertices.size()) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) {
    text += std::string("property float ") + name + "\n";
  }
  for (const char* name : {"red", "green", "blue"}) {
    text += std::string("property uchar ") + name + "\n";
  }
  text += "element face " + std::to_string(model.triangles.size()) + "\n";
  return text + "property list uchar int vertex_indices\nend_header\n";
}

}  // namespace

void writePly(std::ostream& stream, const ObjectModel& model, double scale) {
  stream << header(model);
  for (const ObjectModel::Vertex& vertex : model.vertices) {
    const auto& [red, green, blue] = vertex.colour;
    stream << vectorText(scale * vertex.position) << vectorText(vertex.normal)
           << std::to_string(red) + " " + std::to_string(green) + " " + std::to_string(blue) + "\n";
  }
  for (const auto& [a, b, c] : model.triangles) {
    stream << "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
}

}  // namespace v2
}  // namespace synthetic_dataset
