#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace synthetic_dataset::formats::nuscenes {

/// A table of nuScenes, by token.
class TokenTable {
 public:
  /// @throws Error where it is no such table
  explicit TokenTable(const std::filesystem::path& file);

  /// @throws Error where no record has the token
  [[nodiscard]] const nlohmann::json& at(const std::string& token) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, nlohmann::json> records_;
};

/// The table of what is seen in images, by their files.
class ImageAnnotations {
 public:
  explicit ImageAnnotations(const std::filesystem::path& file);

  [[nodiscard]] std::vector<nlohmann::json> of(const std::string& filename) const;

 private:
  std::multimap<std::string, nlohmann::json> records_;
};

}  // namespace synthetic_dataset::formats::nuscenes
