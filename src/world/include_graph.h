#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "world/findings.h"
#include "world/resource_finder.h"

namespace synthetic_dataset::world {

/// Which files a world file draws in by `<include>`, found before libsdformat reads it: that asks
/// for a URI without telling which file names it, goes round in circles where files include one
/// another, and says of a missing one nothing but that it is missing.
class IncludeGraph {
 public:
  /// Follows the includes of `file`. Files that are missing, no XML or include themselves become
  /// errors.
  IncludeGraph(const std::filesystem::path& file, const ResourceFinder& finder, Findings& findings);

  /// Whether libsdformat can be let loose on the file: it is XML, and nothing includes itself.
  [[nodiscard]] bool isReadable() const { return readable_; }

  /// What each URI means, a file or a model's folder, in the order in which the includes are read;
  /// an empty path where nothing was found.
  using Targets = std::map<std::string, std::vector<std::filesystem::path>>;
  [[nodiscard]] const Targets& targets() const { return targets_; }

 private:
  struct Include {
    std::string uri;
    int line = 0;
  };

  [[nodiscard]] const std::vector<Include>* includesOf(const std::filesystem::path& file);
  void follow(const std::filesystem::path& file);
  void followInclude(const std::filesystem::path& file, const Include& include);

  const ResourceFinder& finder_;
  Findings& findings_;
  std::map<std::string, std::vector<Include>> files_;
  std::vector<std::filesystem::path> chain_;  ///< from the world file to the one being read
  Targets targets_;
  std::set<std::pair<std::string, std::string>> reported_;  ///< missing: in which file, which URI
  int count_ = 0;
  bool readable_ = true;
};

}  // namespace synthetic_dataset::world
