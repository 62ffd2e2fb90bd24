#include "programs/setup_assistant/live/picture_cache.h"

#include <utility>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

constexpr std::size_t kMostPictures = 120;

}  // namespace

std::string PictureCache::add(const cv::Mat& picture, const std::string& extension) {
  auto bytes = std::make_shared<const std::string>(encodedPicture(picture, extension));
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::string name = mark_ + "-" + std::to_string(next_) + extension;
  pictures_[next_++] = {name, std::move(bytes)};
  if (pictures_.size() > kMostPictures) pictures_.erase(pictures_.begin());
  return "api/picture/" + name;
}

std::shared_ptr<const std::string> PictureCache::find(const std::string& name) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& each : pictures_) {
    if (each.second.first == name) return each.second.second;
  }
  return nullptr;
}

std::string encodedPicture(const cv::Mat& picture, const std::string& extension) {
  constexpr int kQuality = 88;
  std::vector<unsigned char> bytes;
  const std::vector<int> options = extension == ".jpg"
                                       ? std::vector<int>{cv::IMWRITE_JPEG_QUALITY, kQuality}
                                       : std::vector<int>{cv::IMWRITE_PNG_COMPRESSION, 1};
  if (picture.empty() || !cv::imencode(extension, picture, bytes, options)) {
    throw Error("the picture cannot be encoded");
  }
  return {bytes.begin(), bytes.end()};
}

}  // namespace synthetic_dataset::programs
