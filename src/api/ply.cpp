#include <ios>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>

#include "synthetic_dataset/object_model.h"

namespace synthetic_dataset {
inline namespace v1 {
namespace {

/// Numbers as the file's `float` properties hold them: the fewest digits that read back as the same
/// float, whatever the locale.
class FloatText {
 public:
  FloatText() {
    writing_.imbue(std::locale::classic());
    reading_.imbue(std::locale::classic());
  }

  std::string of(double number) {
    const float value = static_cast<float>(number) + 0.0F;  // no "-0"
    for (int digits = kFewestDigits;; ++digits) {
      std::string text = printed(value, digits);
      if (digits == kMostDigits || readBack(text) == value) return text;
    }
  }

 private:
  // All floats survive 9 digits, and what 6 digits can say, they say without trailing zeros.
  static constexpr int kFewestDigits = 6;
  static constexpr int kMostDigits = 9;

  std::string printed(float value, int digits) {
    writing_.str("");
    writing_.precision(digits);
    writing_ << value;
    return writing_.str();
  }

  float readBack(const std::string& text) {
    reading_.clear();
    reading_.str(text);
    float value = 0.0F;
    reading_ >> value;
    return value;
  }

  std::ostringstream writing_;
  std::istringstream reading_;
};

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
  FloatText text;
  stream << header(model);
  for (const ObjectModel::Vertex& vertex : model.vertices) {
    std::string line;
    for (const double coordinate : vertex.position) line += text.of(scale * coordinate) + " ";
    for (const double coordinate : vertex.normal) line += text.of(coordinate) + " ";
    const auto& [red, green, blue] = vertex.colour;
    line += std::to_string(red) + " " + std::to_string(green) + " " + std::to_string(blue) + "\n";
    stream << line;
  }
  for (const auto& [a, b, c] : model.triangles) {
    stream << "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
}

}  // namespace v1
}  // namespace synthetic_dataset
