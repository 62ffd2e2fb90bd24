#include "scene/camera_info.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "base/yaml_value.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::scene {
namespace {

using Errors = std::vector<std::string>;

/// The entries of a matrix under either of its names: a group with `data`, or a plain list.
std::vector<double> readMatrix(Parameters& root, const std::string& calibration_name,
                               const std::string& message_name) {
  if (root.has(message_name)) return root.required<std::vector<double>>(message_name);
  return root.group(calibration_name).required<std::vector<double>>("data");
}

template <std::size_t kSize>
std::array<double, kSize> readArray(Parameters& root, const std::string& calibration_name,
                                    const std::string& message_name) {
  std::array<double, kSize> result{};
  const std::size_t errors_before = root.errors().size();
  const std::vector<double> numbers = readMatrix(root, calibration_name, message_name);
  if (root.errors().size() > errors_before) return result;
  if (numbers.size() != kSize) {
    root.addError(calibration_name, "found " + std::to_string(numbers.size()) +
                                        " numbers; it should be " + std::to_string(kSize));
    return result;
  }
  std::copy(numbers.begin(), numbers.end(), result.begin());
  return result;
}

bool hasEither(Parameters& root, const std::string& one, const std::string& other) {
  return root.has(one) || root.has(other);
}

int readSide(Parameters& root, const std::string& calibration_name,
             const std::string& message_name) {
  return root.has(message_name) ? root.required<int>(message_name)
                                : root.required<int>(calibration_name);
}

CameraInfoNumbers readNumbers(Parameters& root, bool rectified) {
  CameraInfoNumbers numbers;
  numbers.width = readSide(root, "image_width", "width");
  numbers.height = readSide(root, "image_height", "height");
  numbers.distortion_model = root.optional<std::string>("distortion_model", "plumb_bob");
  if (rectified) {
    numbers.P = readArray<12>(root, "projection_matrix", "P");
  } else {
    numbers.K = readArray<9>(root, "camera_matrix", "K");
    if (hasEither(root, "D", "distortion_coefficients")) {
      numbers.D = readMatrix(root, "distortion_coefficients", "D");
    }
  }
  numbers.binning_x = root.optional<int>("binning_x", 0);
  numbers.binning_y = root.optional<int>("binning_y", 0);
  if (root.has("roi")) {
    Parameters roi = root.group("roi");
    numbers.roi_x_offset = roi.optional<int>("x_offset", 0);
    numbers.roi_y_offset = roi.optional<int>("y_offset", 0);
    numbers.roi_width = roi.optional<int>("width", 0);
    numbers.roi_height = roi.optional<int>("height", 0);
  }
  return numbers;
}

/// fx, fy, cx, cy of a row-major matrix with `columns` columns.
template <std::size_t kSize>
Intrinsics intrinsicsOf(const std::array<double, kSize>& m, const std::string& name,
                        Errors& errors) {
  constexpr std::size_t kColumns = kSize / 3;
  if (m[1] != 0.0) {
    errors.push_back(name + ": found a skew of " + Value(m[1]).text() + "; it should be 0");
  }
  return {m[0], m[kColumns + 1], m[2], m[kColumns + 2]};
}

struct KnownModel {
  const char* name;
  DistortionModel model;
  std::vector<std::size_t> counts;  ///< of coefficients; zeros may follow the last of them
  const char* coefficients;
};

const std::vector<KnownModel>& knownModels() {
  static const std::vector<KnownModel> models = {
      {"plumb_bob", DistortionModel::kPlumbBob, {4, 5}, "4 or 5 (k1, k2, p1, p2, k3)"},
      {"rational_polynomial",
       DistortionModel::kRationalPolynomial,
       {8},
       "8 (k1, k2, p1, p2, k3, k4, k5, k6)"},
      {"equidistant", DistortionModel::kEquidistant, {4}, "4 (k1, k2, k3, k4)"},
      {"fisheye", DistortionModel::kEquidistant, {4}, "4 (k1, k2, k3, k4)"},
  };
  return models;
}

bool isZero(double number) { return number == 0.0; }

/// A list without entries stands for no distortion, as CameraInfo has it.
Distortion distortionOf(const CameraInfoNumbers& numbers, Errors& errors) {
  const auto& known = knownModels();
  const auto model = std::find_if(known.begin(), known.end(), [&](const KnownModel& candidate) {
    return candidate.name == numbers.distortion_model;
  });
  const bool all_zero = std::all_of(numbers.D.begin(), numbers.D.end(), isZero);
  if (model == known.end()) {
    if (all_zero && numbers.distortion_model.empty()) return {};
    errors.push_back("distortion_model: found '" + numbers.distortion_model +
                     "'; it should be plumb_bob, rational_polynomial, equidistant or fisheye");
    return {};
  }
  if (numbers.D.empty() && model->model != DistortionModel::kEquidistant) return {};
  const std::size_t most = model->counts.back();
  const bool is_short = numbers.D.size() < most &&
                        std::find(model->counts.begin(), model->counts.end(), numbers.D.size()) ==
                            model->counts.end();
  const auto beyond =
      numbers.D.begin() + static_cast<std::ptrdiff_t>(std::min(most, numbers.D.size()));
  if (is_short || !std::all_of(beyond, numbers.D.end(), isZero)) {
    errors.push_back("distortion_coefficients: found " + std::to_string(numbers.D.size()) +
                     " numbers; " + numbers.distortion_model + " has " + model->coefficients +
                     ", and what follows them should be 0 (a thin prism or a tilted sensor is not "
                     "drawn)");
    return {};
  }
  // A fisheye without coefficients is still a fisheye.
  if (all_zero && model->model != DistortionModel::kEquidistant) return {};
  Distortion distortion;
  distortion.model = model->model;
  std::copy(numbers.D.begin(), beyond, distortion.coefficients.begin());
  return distortion;
}

/// What is read out of one of the sensor's sides.
struct Readout {
  double offset = 0.0;   ///< [sensor px]
  double binning = 1.0;  ///< [sensor px] for one of the image
  int size = 0;          ///< [px] of the image

  /// Pixel centres have whole coordinates: image pixel i covers the sensor's from offset - 0.5 +
  /// i binning on, hence half a binned pixel on either side.
  [[nodiscard]] double place(double centre) const {
    return (centre + 0.5 - offset) / binning - 0.5;
  }
};

struct Side {
  const char* binning_name;
  const char* roi_name;
  int whole;
  int binning;
  int offset;
  int roi_size;
};

Readout readoutOf(const Side& side, Errors& errors) {
  const int binning = std::max(side.binning, 1);
  if (side.binning < 0) {
    errors.push_back(std::string(side.binning_name) + ": found " + std::to_string(side.binning) +
                     "; it should be 0 or more");
  }
  const std::int64_t whole = side.whole;
  const std::int64_t size = side.roi_size == 0 ? whole - side.offset : side.roi_size;
  if (side.offset < 0 || size < 1 || side.offset + size > whole) {
    errors.push_back(std::string("roi/") + side.roi_name + ": found " +
                     std::to_string(side.roi_size) + " px from " + std::to_string(side.offset) +
                     " on; it should lie within the image's " + std::to_string(side.whole) + " px");
  }
  return {static_cast<double>(side.offset), static_cast<double>(binning),
          static_cast<int>(size / binning)};
}

[[noreturn]] void throwNaming(const std::string& file, const Errors& errors) {
  Errors named;
  for (const std::string& error : errors) named.push_back(file + ": " + error);
  throw ErrorList(named);
}

}  // namespace

CameraModel cameraModelFrom(const CameraInfoNumbers& numbers, bool rectified, double near,
                            double far) {
  Errors errors;
  if (rectified && !numbers.P) {
    throw Error("projection_matrix: required for the rectified camera");
  }
  const Intrinsics k = rectified ? intrinsicsOf(*numbers.P, "projection_matrix", errors)
                                 : intrinsicsOf(numbers.K, "camera_matrix", errors);
  const Distortion distortion = rectified ? Distortion{} : distortionOf(numbers, errors);
  for (const auto& [name, size] :
       {std::pair("image_width", numbers.width), std::pair("image_height", numbers.height)}) {
    if (size < 1) {
      errors.push_back(std::string(name) + ": found " + std::to_string(size) +
                       "; it should be at least 1");
    }
  }
  if (!errors.empty()) throw ErrorList(errors);
  const Readout across = readoutOf({"binning_x", "width", numbers.width, numbers.binning_x,
                                    numbers.roi_x_offset, numbers.roi_width},
                                   errors);
  const Readout down = readoutOf({"binning_y", "height", numbers.height, numbers.binning_y,
                                  numbers.roi_y_offset, numbers.roi_height},
                                 errors);
  if (!errors.empty()) throw ErrorList(errors);
  const Intrinsics image{k.fx / across.binning, k.fy / down.binning, across.place(k.cx),
                         down.place(k.cy)};
  return CameraModel(across.size, down.size, image, near, far, distortion);
}

CameraModel cameraModelOf(const Value& info, const std::string& origin, bool rectified, double near,
                          double far) {
  Parameters root(info);
  const CameraInfoNumbers numbers = readNumbers(root, rectified);
  if (!root.errors().empty()) throwNaming(origin, root.errors());
  try {
    return cameraModelFrom(numbers, rectified, near, far);
  } catch (const ErrorList& errors) {
    throwNaming(origin, errors.messages());
  } catch (const Error& error) {
    throw Error(origin + ": " + error.what());
  }
}

CameraModel readCameraInfo(const std::string& file, bool rectified, double near, double far) {
  return cameraModelOf(base::loadYamlFile(file), file, rectified, near, far);
}

}  // namespace synthetic_dataset::scene
