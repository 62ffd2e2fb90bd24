#include "motion/bag/bag.h"

#include <filesystem>
#include <system_error>

#include "motion/bag/ros1_bag.h"
#include "motion/bag/ros2_bag.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

std::unique_ptr<Bag> openBag(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status)) throw Error("bag " + path + ": no such file");
  if (isRos2Bag(path)) throw Error("bag " + path + ": " + convertAdvice(path));
  if (std::filesystem::is_directory(status)) {
    throw Error("bag " + path + ": is a folder; a bag file is needed");
  }
  return openRos1Bag(path);
}

}  // namespace synthetic_dataset::motion
