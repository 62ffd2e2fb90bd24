#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <utility>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::programs {

/// The last pictures that were drawn, as files, under the addresses from which pages fetch them.
class PictureCache {
 public:
  /// @param picture  8 bit BGR
  /// @param extension  ".jpg" or ".png"
  /// @return its address
  [[nodiscard]] std::string add(const cv::Mat& picture, const std::string& extension);

  /// A file's bytes by the last part of its address; null if it is not kept any more.
  [[nodiscard]] std::shared_ptr<const std::string> find(const std::string& name) const;

 private:
  /// Differs from server to server, as browsers cache an earlier server's pictures by address.
  std::string mark_ = std::to_string(std::random_device()());
  mutable std::mutex mutex_;
  std::int64_t next_ = 1;
  std::map<std::int64_t, std::pair<std::string, std::shared_ptr<const std::string>>> pictures_;
};

/// Encodes a picture as the bytes of a file.
[[nodiscard]] std::string encodedPicture(const cv::Mat& picture, const std::string& extension);

}  // namespace synthetic_dataset::programs
