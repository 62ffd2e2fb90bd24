#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace synthetic_dataset::formats::coco {

/// An index of the entries' positions in a COCO annotation file, so that one scene's entries can be
/// read on their own: a dataset's file may be larger than memory.
class CocoIndex {
 public:
  /// Reads the file once, entry by entry.
  /// @throws Error if it is not such a file
  explicit CocoIndex(const std::filesystem::path& file);

  /// The id of an image.
  /// @param file_name  as written in the file
  [[nodiscard]] std::optional<std::int64_t> imageId(const std::string& file_name) const;

  /// @throws Error if the file has changed and they are no longer valid JSON
  [[nodiscard]] std::vector<nlohmann::json> annotationsOf(std::int64_t image_id) const;

  [[nodiscard]] const std::vector<nlohmann::json>& categories() const { return categories_; }

 private:
  /// A range of bytes in the file.
  struct Place {
    std::int64_t begin = 0;
    std::int64_t end = 0;
  };
  class Reader;

  [[nodiscard]] nlohmann::json entryAt(const Place& place) const;

  std::filesystem::path file_;
  std::map<std::string, std::int64_t> image_ids_;
  std::map<std::int64_t, std::vector<Place>> annotations_;  ///< by the image's id
  std::vector<nlohmann::json> categories_;
};

}  // namespace synthetic_dataset::formats::coco
