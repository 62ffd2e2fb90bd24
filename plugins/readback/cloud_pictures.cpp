#include "plugins/readback/cloud_pictures.h"

#include <cstring>

#include <opencv2/core.hpp>

#include "plugins/readback/files.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {

std::optional<std::size_t> lidarNamed(const std::string& name, const DatasetInfo& dataset) {
  for (std::size_t i = 0; i < dataset.lidars.size(); ++i) {
    if (dataset.lidars[i].name == name) return i;
  }
  return std::nullopt;
}

DecodedPicture velodynePicture(const std::filesystem::path& file, std::size_t lidar,
                               const Value::Map& settings) {
  constexpr std::size_t kBytesOfAPoint = 16;
  const std::string bytes = readText(file);
  if (bytes.size() % kBytesOfAPoint != 0) {
    throw Error("'" + file.string() + "': it ends within a point");
  }
  DecodedPicture picture;
  cv::Mat points(static_cast<int>(bytes.size() / kBytesOfAPoint), 1, CV_32FC4);
  if (!bytes.empty()) std::memcpy(points.data, bytes.data(), bytes.size());
  const auto corrected = settings.find("motion_corrected");
  const bool is_measured = corrected != settings.end() && corrected->second == Value(false);
  picture.name = picture.stored_as =
      "cloud_" + std::to_string(lidar) + (is_measured ? "_measured" : "");
  picture.stored = points;
  picture.files = {file};
  return picture;
}

}  // namespace synthetic_dataset::formats
