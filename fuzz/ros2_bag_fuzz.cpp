// Files of ROS 2 bags, as rosbag2's two storages have them, and their transforms.
#include "fuzzing.h"
#include "motion/bag_motion.h"
#include "motion/recorded/recorded_camera_info.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace synthetic_dataset;
  const std::string bag = fuzzing::write("input.zstd", fuzzing::view(data, size)).string();
  fuzzing::tolerating([&] {
    const auto reader = motion::openBag(bag);
    const auto messages = reader->messages([](const std::string& /*topic*/) { return true; });
    while (const auto message = messages->next()) {
      if (message->md5sum.empty()) continue;
      fuzzing::tolerating([&] { static_cast<void>(message->bytes()); });
    }
    fuzzing::tolerating([&] { static_cast<void>(motion::readCameraInfo({bag}, "/camera_info")); });
    static_cast<void>(motion::BagMotion({bag}, "map").timeline({"robot"}, {}));
  });
  return 0;
}
