// Bags: their records, and the transforms, calibrations and maps recorded in them.
#include "fuzzing.h"
#include "motion/bag/bag_check.h"
#include "motion/bag_motion.h"
#include "motion/recorded/recorded_camera_info.h"
#include "motion/recorded/recorded_map.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace synthetic_dataset;
  const std::string bag = fuzzing::write("input.bag", fuzzing::view(data, size)).string();
  // librosbag takes milliseconds to start: only bags that pass our own checks get that far.
  fuzzing::tolerating([&] {
    static_cast<void>(
        motion::checkBag(bag, [](const std::string& topic) { return topic != "/other"; }));
    fuzzing::tolerating([&] { static_cast<void>(motion::readCameraInfo({bag}, "/camera_info")); });
    fuzzing::tolerating([&] { static_cast<void>(motion::readMap({bag}, "/map")); });
    const motion::BagMotion motion({bag}, "map");
    static_cast<void>(motion.timeline({"robot"}, {}));
  });
  return 0;
}
