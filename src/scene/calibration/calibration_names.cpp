#include "scene/calibration/calibration_names.h"

#include <cctype>
#include <cmath>
#include <utility>

#include "base/yaml_scalar.h"

namespace synthetic_dataset::scene {

std::string plainName(const std::string& name) {
  std::string plain;
  for (const char letter : name) {
    if (letter != '_') plain += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return plain;
}

const std::map<std::string, std::string>& rosNames() {
  static const std::map<std::string, std::string> names = {
      {"imagewidth", "image_width"},
      {"width", "image_width"},
      {"imageheight", "image_height"},
      {"height", "image_height"},
      {"distortionmodel", "distortion_model"},
      {"cameramatrix", "camera_matrix"},
      {"k", "camera_matrix"},
      {"distortioncoefficients", "distortion_coefficients"},
      {"d", "distortion_coefficients"},
      {"rectificationmatrix", "rectification_matrix"},
      {"r", "rectification_matrix"},
      {"projectionmatrix", "projection_matrix"},
      {"p", "projection_matrix"},
  };
  return names;
}

namespace {

/// 1e-05 is a number to ROS's readers, but a text in YAML 1.1.
Value asNumber(const Value& entry) {
  const auto* text = entry.as<std::string>();
  const auto number = text != nullptr ? base::decimalNumber(*text) : std::nullopt;
  return number ? Value(*number) : entry;
}

}  // namespace

Value pixelCount(double number) {
  constexpr double kMost = 1e9;
  const bool is_whole = number >= 0.0 && number <= kMost && number == std::floor(number);
  return is_whole ? Value(static_cast<int>(number)) : Value(number);
}

Value flatMatrix(const Value& matrix) {
  if (const auto* group = matrix.as<Value::Map>()) {
    const auto data = group->find("data");
    return data == group->end() ? matrix : flatMatrix(data->second);
  }
  const auto* rows = matrix.as<Value::List>();
  if (rows == nullptr) return matrix;
  Value::List flat;
  for (const Value& row : *rows) {
    const auto* entries = row.as<Value::List>();
    if (entries == nullptr) {
      flat.push_back(asNumber(row));
      continue;
    }
    for (const Value& entry : *entries) flat.push_back(asNumber(entry));
  }
  return flat;
}

Value::Map withUsualNames(const Value::Map& map, const std::map<std::string, std::string>& names) {
  Value::Map result;
  for (const auto& [name, value] : map) {
    const auto usual = names.find(plainName(name));
    const std::string& known = usual == names.end() ? name : usual->second;
    const bool is_list = known == "distortion_coefficients" ||
                         (known.size() > 7 && known.compare(known.size() - 7, 7, "_matrix") == 0);
    result.emplace(known, is_list ? flatMatrix(value) : value);
  }
  return result;
}

}  // namespace synthetic_dataset::scene
