#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace synthetic_dataset::formats::image_folder {

/// Where in a file of JSON lines each image's line begins.
class LineIndex {
 public:
  /// @throws Error where a line is no JSON with a `file_name`
  explicit LineIndex(const std::filesystem::path& file);

  /// @throws Error where there is no line of this `file_name`
  [[nodiscard]] nlohmann::json line(const std::string& file_name) const;

  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::filesystem::path file_;
  std::map<std::string, std::int64_t> begins_;
  std::size_t count_ = 0;
};

}  // namespace synthetic_dataset::formats::image_folder
