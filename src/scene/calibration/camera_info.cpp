#include "scene/calibration/camera_info.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "base/diagnostics.h"
#include "scene/calibration/calibration_names.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::scene {
namespace {

using Errors = std::vector<std::string>;
using Warnings = std::vector<std::string>;

/// Reads a matrix with this many numbers.
template <std::size_t kSize>
std::optional<std::array<double, kSize>> readMatrix(Parameters& root, const std::string& name) {
  const auto numbers = root.maybe<std::vector<double>>(name);
  if (!numbers) return std::nullopt;
  if (numbers->size() != kSize) {
    root.addError(name, "found " + std::to_string(numbers->size()) + " numbers; it should be " +
                            std::to_string(kSize));
    return std::nullopt;
  }
  std::array<double, kSize> result{};
  std::copy(numbers->begin(), numbers->end(), result.begin());
  return result;
}

/// A driver without a calibration sends zeros; one of rectified pictures may set only P.
bool isUncalibrated(const std::array<double, 9>& K) { return K[0] == 0.0 && K[4] == 0.0; }

CameraInfoNumbers readNumbers(Parameters& root, bool rectified) {
  CameraInfoNumbers numbers;
  if (!root.has("image_width") && !root.has("image_height")) {
    root.addError("image_width", "required, and image_height: the size of the image [px]");
  } else {
    numbers.width = root.required<int>("image_width");
    numbers.height = root.required<int>("image_height");
  }
  numbers.distortion_model = root.optional<std::string>("distortion_model", "plumb_bob");
  if (rectified) {
    numbers.R = readMatrix<9>(root, "rectification_matrix");
    numbers.P = readMatrix<12>(root, "projection_matrix");
  } else {
    if (!root.has("camera_matrix")) (void)root.required<std::vector<double>>("camera_matrix");
    numbers.K = readMatrix<9>(root, "camera_matrix").value_or(std::array<double, 9>{});
    if (isUncalibrated(numbers.K) && root.has("projection_matrix")) {
      numbers.P = readMatrix<12>(root, "projection_matrix");
    }
    numbers.D =
        root.maybe<std::vector<double>>("distortion_coefficients").value_or(std::vector<double>{});
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

/// fx, fy, cx, cy of a row-major matrix with three rows.
template <std::size_t kSize>
Intrinsics intrinsicsOf(const std::array<double, kSize>& m, const std::string& name,
                        Warnings& warnings) {
  constexpr std::size_t kColumns = kSize / 3;
  if (m[1] != 0.0) {
    warnings.push_back(name + ": found a skew of " + Value(m[1]).text() +
                       "; it is not drawn, as ROS and OpenCV project without it too");
  }
  return {m[0], m[kColumns + 1], m[2], m[kColumns + 2]};
}

Distortion distortionOf(const CameraInfoNumbers& numbers, Warnings& warnings, Errors& errors) {
  try {
    const Distortion distortion = makeDistortion(numbers.distortion_model, numbers.D);
    if (!isDistortionModelName(numbers.distortion_model)) {
      warnings.push_back("distortion_model: found '" + numbers.distortion_model +
                         "', whose coefficients are all 0; it is drawn without distortion");
    }
    return distortion;
  } catch (const Error& error) {
    errors.emplace_back(error.what());
  }
  return {};
}

Eigen::Matrix3d rotationOf(const std::array<double, 9>& numbers, Errors& errors) {
  constexpr double kTolerance = 1e-2;  // numbers may be rounded
  const Eigen::Matrix3d R =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers.data());
  const double stray = (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (stray <= kTolerance && R.determinant() > 0.0) return R;
  errors.emplace_back("rectification_matrix: it should be a rotation, but is not");
  return Eigen::Matrix3d::Identity();
}

/// http://docs.ros.org/en/noetic/api/sensor_msgs/html/msg/CameraInfo.html: R rotates points into
/// the rectified frame, and P projects them; P's fourth column gives the position of a stereo
/// pair's second camera.
Pose rectifiedPose(const CameraInfoNumbers& numbers, Errors& errors) {
  const std::array<double, 12>& P = *numbers.P;
  if (P[11] != 0.0) {
    errors.push_back("projection_matrix: found " + Value(P[11]).text() +
                     " at its end; it should be 0");
  }
  Pose X_CF = Pose::Identity();
  if (numbers.R) {
    const Eigen::Matrix3d R = rotationOf(*numbers.R, errors);
    if (!R.isIdentity(0.0)) X_CF = makePose(Eigen::Vector3d::Zero(), Eigen::Quaterniond(R));
  }
  const bool has_place = P[3] != 0.0 || P[7] != 0.0;
  if (has_place && P[0] != 0.0 && P[5] != 0.0) {
    X_CF.translation() = Eigen::Vector3d(P[3] / P[0], P[7] / P[5], 0.0);
  }
  return X_CF.isApprox(Pose::Identity(), 0.0) ? Pose::Identity() : Pose(X_CF.inverse());
}

/// The part of the sensor that is read out, along one of its sides.
struct Readout {
  double offset = 0.0;   ///< [sensor px]
  double binning = 1.0;  ///< [sensor px] per image pixel
  int size = 0;          ///< [px] of the image

  /// Converts a sensor coordinate to an image coordinate. Pixel centres have whole coordinates:
  /// image pixel i covers the sensor from offset - 0.5 + i * binning on, hence the shifts by half a
  /// pixel.
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

}  // namespace

CalibratedCamera cameraFrom(const CameraInfoNumbers& numbers, const CalibrationUse& use) {
  Errors errors;
  Warnings warnings;
  if (use.rectified && !numbers.P) {
    throw Error("projection_matrix: required for the rectified camera");
  }
  if (!use.rectified && isUncalibrated(numbers.K)) {
    const bool has_other = numbers.P && (*numbers.P)[0] > 0.0 && (*numbers.P)[5] > 0.0;
    throw Error(std::string("camera_matrix (K): its focal lengths are 0, as sent by a driver "
                            "without a calibration; ") +
                (has_other ? "projection_matrix (P) is set: `rectified: true` takes it, for "
                             "pictures that are rectified"
                           : "the camera should be calibrated, or info_file name a calibration"));
  }
  const Intrinsics k = use.rectified ? intrinsicsOf(*numbers.P, "projection_matrix", warnings)
                                     : intrinsicsOf(numbers.K, "camera_matrix", warnings);
  const Distortion distortion =
      use.rectified ? Distortion{} : distortionOf(numbers, warnings, errors);
  const Pose X_FC = use.rectified ? rectifiedPose(numbers, errors) : Pose::Identity();
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
  return {CameraModel(across.size, down.size, image, use.near, use.far, distortion), X_FC, "",
          warnings};
}

CalibratedCamera cameraOf(const Value& info, const std::string& origin, const CalibrationUse& use) {
  const auto* map = info.as<Value::Map>();
  if (map == nullptr) throw Error(origin + ": found " + info.kind() + "; it should be a group");
  Parameters root(Value(withUsualNames(*map, rosNames())));
  const CameraInfoNumbers numbers = readNumbers(root, use.rectified);
  const std::string frame =
      root.has("header") ? root.group("header").optional<std::string>("frame_id", "") : "";
  if (!root.errors().empty()) {
    base::namingPlace(origin, [&] { throw ErrorList(root.errors()); });
  }
  return base::namingPlace(origin, [&] {
    CalibratedCamera camera = cameraFrom(numbers, use);
    camera.frame = frame;
    return camera;
  });
}

}  // namespace synthetic_dataset::scene
