#include "motion/bag/bag.h"

#include <filesystem>
#include <system_error>

#include "base/input_file.h"
#include "motion/bag/ros1_bag.h"
#include "motion/bag/ros2_bag.h"
#include "motion/ros2/bag_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

bool isBagPath(const std::string& path) {
  return std::filesystem::path(path).extension() == ".bag" || hasStorageName(path) ||
         isRos2Bag(path);
}

std::unique_ptr<Bag> openBag(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status)) {
    throw Error("bag " + path + ": no such file" + base::didYouMeanFile(path));
  }
  if (isRos2Bag(path)) return openRos2Bag(path);
  if (std::filesystem::is_directory(status)) {
    throw Error("bag " + path +
                ": is a folder; a bag file is needed, or a ROS 2 bag folder with metadata.yaml");
  }
  return openRos1Bag(path);
}

}  // namespace synthetic_dataset::motion
