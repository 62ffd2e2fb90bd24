#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace synthetic_dataset::formats::coco {

/// Where the entries of a COCO annotation file stand in it, so that a scene's can be read alone: a
/// dataset's file may be larger than the memory.
class CocoIndex {
 public:
  /// Reads the file once, entry by entry.
  /// @throws Error where it is no such file
  explicit CocoIndex(const std::filesystem::path& file);

  /// The id of an image.
  /// @param file_name  as the file has it
  [[nodiscard]] std::optional<std::int64_t> imageId(const std::string& file_name) const;

  /// @throws Error where they are not the JSON that stood there before
  [[nodiscard]] std::vector<nlohmann::json> annotationsOf(std::int64_t image_id) const;

  [[nodiscard]] const std::vector<nlohmann::json>& categories() const { return categories_; }

 private:
  /// Some bytes of the file.
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
