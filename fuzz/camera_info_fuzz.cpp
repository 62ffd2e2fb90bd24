// Calibrations in the formats that we read ourselves, and the cameras that result. OpenCV's
// FileStorage is left to OpenCV's own reader.
#include <string>

#include "fuzzing.h"
#include "scene/calibration/calibration_file.h"
#include "scene/calibration/calibration_format.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace synthetic_dataset;
  const std::string text(fuzzing::view(data, size));
  if (scene::kOpenCvFormat.recognises(text)) return 0;
  for (const bool rectified : {false, true}) {
    fuzzing::tolerating([&] {
      const CameraModel camera =
          scene::parseCalibration(text, "camera_info", {}, {rectified, 0.01, 100.0}).model;
      for (const double x : {-2.0, 0.0, 0.7}) {
        static_cast<void>(camera.project(Eigen::Vector3d(x, 0.5, 1.0)));
      }
    });
  }
  return 0;
}
