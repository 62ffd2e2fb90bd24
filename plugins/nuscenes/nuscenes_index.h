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
  /// @throws Error if it is not such a table
  explicit TokenTable(const std::filesystem::path& file);

  /// @throws Error if no record has the token
  [[nodiscard]] const nlohmann::json& at(const std::string& token) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, nlohmann::json> records_;
};

/// A table's records, indexed by the text of one of their members.
class RecordsByKey {
 public:
  /// @param key  the member by which records are indexed
  RecordsByKey(const std::filesystem::path& file, const char* key);

  [[nodiscard]] std::vector<nlohmann::json> of(const std::string& text) const;

 private:
  std::multimap<std::string, nlohmann::json> records_;
};

struct RecordsByFile : RecordsByKey {
  explicit RecordsByFile(const std::filesystem::path& file) : RecordsByKey(file, "filename") {}
};

struct RecordsBySample : RecordsByKey {
  explicit RecordsBySample(const std::filesystem::path& file)
      : RecordsByKey(file, "sample_token") {}
};

}  // namespace synthetic_dataset::formats::nuscenes
