#include "config/camera_info.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "config/yaml_value.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {
namespace {

/// The entries of a matrix under either of its names: a group with `data`, or a plain list.
std::vector<double> readMatrix(const Parameters& root, const std::string& calibration_name,
                               const std::string& message_name) {
  if (root.has(message_name)) return root.required<std::vector<double>>(message_name);
  return root.group(calibration_name).required<std::vector<double>>("data");
}

int readSide(const Parameters& root, const std::string& calibration_name,
             const std::string& message_name) {
  return root.has(message_name) ? root.required<int>(message_name)
                                : root.required<int>(calibration_name);
}

bool allZero(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double number) { return number == 0.0; });
}

/// fx, fy, cx, cy of a row-major matrix with `columns` columns.
std::optional<Intrinsics> intrinsicsOf(const Parameters& root, const std::string& name,
                                       const std::vector<double>& m, std::size_t columns) {
  if (m.size() != 3 * columns) {
    root.addError(name, "found " + std::to_string(m.size()) + " numbers; it should be " +
                            std::to_string(3 * columns));
    return std::nullopt;
  }
  if (m[1] != 0.0) {
    root.addError(name, "found a skew of " + Value(m[1]).text() + "; it should be 0");
    return std::nullopt;
  }
  return Intrinsics{m[0], m[columns + 1], m[2], m[columns + 2]};
}

std::optional<Intrinsics> readIntrinsics(const Parameters& root, bool rectified) {
  if (rectified) {
    return intrinsicsOf(root, "projection_matrix", readMatrix(root, "projection_matrix", "P"), 4);
  }
  if (root.has("D") || root.has("distortion_coefficients")) {
    if (!allZero(readMatrix(root, "distortion_coefficients", "D"))) {
      root.addError("distortion_coefficients",
                    "found a lens distortion, which is not rendered; set camera/rectified: true "
                    "for pictures of the rectified camera (its projection matrix)");
    }
  }
  return intrinsicsOf(root, "camera_matrix", readMatrix(root, "camera_matrix", "K"), 3);
}

}  // namespace

CameraModel readCameraInfo(const std::string& file, bool rectified, double near, double far) {
  const Parameters root(loadYamlFile(file));
  const int width = readSide(root, "image_width", "width");
  const int height = readSide(root, "image_height", "height");
  const auto intrinsics = readIntrinsics(root, rectified);
  if (!root.errors().empty()) {
    std::vector<std::string> errors;
    for (const std::string& error : root.errors()) errors.push_back(file + ": " + error);
    throw ErrorList(errors);
  }
  try {
    return CameraModel(width, height, *intrinsics, near, far);
  } catch (const Error& error) {
    throw Error(file + ": " + error.what());
  }
}

}  // namespace synthetic_dataset::config
