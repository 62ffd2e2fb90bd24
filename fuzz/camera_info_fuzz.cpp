// Calibrations: camera_info YAML, and the camera that it makes.
#include "base/yaml_value.h"
#include "fuzzing.h"
#include "scene/camera_info.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace synthetic_dataset;
  for (const bool rectified : {false, true}) {
    fuzzing::tolerating([&] {
      const Value info = base::parseYaml(std::string(fuzzing::view(data, size)), "camera_info");
      const CameraModel camera = scene::cameraModelOf(info, "camera_info", rectified, 0.01, 100.0);
      for (const double x : {-2.0, 0.0, 0.7}) {
        static_cast<void>(camera.project(Eigen::Vector3d(x, 0.5, 1.0)));
      }
    });
  }
  return 0;
}
