#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "plugins/coco/coco_index.h"
#include "plugins/readback/drawn_label.h"

namespace synthetic_dataset::readback {

/// Where in a file of JSON lines each image's line begins.
class LineIndex {
 public:
  /// @throws Error where a line is no JSON with a `file_name`
  explicit LineIndex(const std::filesystem::path& file);

  /// @throws Error where there is no line of this `file_name`
  [[nodiscard]] nlohmann::json line(const std::string& file_name) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, std::int64_t> begins_;
};

/// What readers keep from scene to scene of files that tell of many, so that each is read once and
/// not for every scene.
struct KeptFiles {
  std::map<std::filesystem::path, CocoIndex> coco;
  std::map<std::filesystem::path, LineIndex> lines;
  std::map<std::filesystem::path, nlohmann::json> documents;  ///< whole; only a few

  /// A file's JSON, valid until the next call.
  [[nodiscard]] const nlohmann::json& document(const std::filesystem::path& file);
};

/// The scene's, or new ones where it has none.
[[nodiscard]] std::shared_ptr<KeptFiles> keptFilesOf(const WrittenScene& scene);

}  // namespace synthetic_dataset::readback
