#include "world/sdf/sdf_cameras.h"

#include <cmath>
#include <string>

#include "synthetic_dataset/errors.h"
#include "world/camera_frames.h"
#include "world/sdf/sdf_lenses.h"
#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

/// fx = width / (2 tan(hfov / 2)) with square pixels, as for Gazebo's camera. The optical axis
/// passes through the middle of the image, which is (width - 1) / 2 if pixel centres have whole
/// coordinates.
Intrinsics fromFieldOfView(const CameraImage& image) {
  const double angle = image.field_of_view;
  if (!(angle > 0.0 && angle < 3.14159)) {
    throw Error("horizontal_fov: found " + shortText(angle) +
                "; it should be above 0 and below pi rad");
  }
  const double focal_length = image.width / (2.0 * std::tan(0.5 * angle));
  return {focal_length, focal_length, 0.5 * (image.width - 1.0), 0.5 * (image.height - 1.0)};
}

/// Reads the `<camera>` of a sensor.
class CameraReader {
 public:
  CameraReader(const Element& camera, const SourceLocation& location, SdfReading& reading)
      : camera_(camera), location_(location), reading_(reading) {
    image_.width = static_cast<int>(number(camera.child("image"), "width", image_.width));
    image_.height = static_cast<int>(number(camera.child("image"), "height", image_.height));
    image_.field_of_view = number(camera, "horizontal_fov", image_.field_of_view);
  }

  [[nodiscard]] CameraModel model(bool wide_angle) const {
    const Lens lens = wide_angle
                          ? wideAngleLens(image_, camera_, location_, reading_)
                          : Lens{intrinsics(), brownDistortion(camera_, location_, reading_)};
    return CameraModel(image_.width, image_.height, lens.intrinsics, clip("near", 0.1, 0.05),
                       clip("far", 100.0, 1000.0), lens.distortion);
  }

  [[nodiscard]] PixelNoise noise() const {
    const Element noise = camera_.child("noise");
    const PixelNoise result{number(noise, "mean", 0.0), number(noise, "stddev", 0.0)};
    if (!(result.stddev >= 0.0 && result.stddev <= 1.0) || !(std::abs(result.mean) <= 1.0)) {
      throw Error("noise: found a mean of " + shortText(result.mean) +
                  " and a standard deviation of " + shortText(result.stddev) +
                  "; they are shares of full scale, -1 to 1 and 0 to 1");
    }
    return result;
  }

 private:
  [[nodiscard]] double number(const Element& parent, const char* name, double fallback) const {
    return readNumber(parent, name, fallback, location_, reading_);
  }

  /// @param usual  SDF's default, for a <clip> that omits it [m]
  /// @param unbounded  the value without a <clip> [m]
  [[nodiscard]] double clip(const char* name, double usual, double unbounded) const {
    const Element clip = camera_.child("clip");
    return clip ? number(clip, name, usual) : unbounded;
  }

  /// Intrinsics given in the file are those that camera_info should contain.
  [[nodiscard]] Intrinsics intrinsics() const {
    const Element given = camera_.child("lens").child("intrinsics");
    if (!given) return fromFieldOfView(image_);
    return {number(given, "fx", 277.0), number(given, "fy", 277.0), number(given, "cx", 160.0),
            number(given, "cy", 120.0)};
  }

  const Element& camera_;
  const SourceLocation& location_;
  SdfReading& reading_;
  CameraImage image_;
};

}  // namespace

std::vector<CameraSensor> readCameras(const Element& sensor, const std::string& name,
                                      const Pose& X_WL, const Pose& X_LS,
                                      const SourceLocation& location, SdfReading& reading) {
  const std::string type = readText(sensor, "type");
  const bool wide_angle = type == "wideanglecamera" || type == "wide_angle_camera";
  const bool is_several = type == "multicamera";
  std::vector<CameraSensor> cameras;
  for (const Element& camera : sensor.children("camera")) {
    const SourceLocation here = is_several ? locationOf(camera, location) : location;
    try {
      const CameraReader reader(camera, here, reading);
      const Pose X_LC = X_LS * readPose(camera, here, reading).pose * opticalInBody();
      cameras.push_back({is_several ? name + "::" + camera.attribute("name") : name, X_WL * X_LC,
                         reader.model(wide_angle), reader.noise(), "", X_LC});
    } catch (const Error& error) {
      reading.findings.addNote(here, std::string(error.what()) + "; the camera is left out");
    }
    if (!is_several) break;
  }
  return cameras;
}

}  // namespace synthetic_dataset::world
