#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "world/files/findings.h"
#include "world/files/resource_finder.h"
#include "world/sdf/mentioned_meshes.h"
#include "world/sdf/sdf_copies.h"

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace synthetic_dataset::world {

/// The files that a world file draws in by `<include>`, found and adapted before libsdformat reads
/// them. That asks for a URI without telling which file names it, goes round in circles where files
/// include one another, refuses a whole world for one missing file without saying where it was
/// looked for, and knows no SDF newer than itself. It is given copies that name their includes by
/// path, without what is missing and without what has no part in a picture.
class IncludeGraph {
 public:
  /// Follows the includes of `file`. Included files that are missing, no XML or include themselves
  /// are found missing; a fault of `file` itself is an error.
  /// @param text  the content where it is in no file: `file` is its name for messages then
  IncludeGraph(const std::filesystem::path& file, const ResourceFinder& finder, Findings& findings,
               std::optional<std::string> text = std::nullopt);

  /// Whether libsdformat can be let loose on the file.
  [[nodiscard]] bool isReadable() const { return !prepared_file_.empty(); }

  /// What libsdformat is to read in place of the file.
  [[nodiscard]] const std::filesystem::path& preparedFile() const { return prepared_file_; }
  [[nodiscard]] const SdfCopies& copies() const { return copies_; }

  /// The same with models in the place of includes (see joinModels), which is quicker to read;
  /// empty if there are none. What libsdformat finds wrong with it, it tells of wrong lines.
  [[nodiscard]] const std::filesystem::path& joinedFile() const { return joined_file_; }

  /// Whether some file has a plugin of gz-sim's.
  [[nodiscard]] bool isOfGz() const { return is_of_gz_; }

  /// The meshes of all files that were followed.
  [[nodiscard]] const std::vector<MentionedMesh>& meshes() const { return meshes_; }

 private:
  /// What has become of a file.
  struct Prepared {
    std::filesystem::path path;  ///< what libsdformat is to read
    std::size_t includes = 0;    ///< how many files it draws in, and they in turn
    std::string fault;           ///< why it cannot be read, or empty
    std::shared_ptr<tinyxml2::XMLDocument> content{};  ///< of `path`; not of URDF files
  };

  /// @throws Error if the file cannot be read
  const Prepared& prepare(const std::filesystem::path& file);
  Prepared read(const std::filesystem::path& file);
  Prepared readBuiltIn(const std::string& name, const std::string& text);
  void adapt(tinyxml2::XMLElement& parent, const std::filesystem::path& file, Prepared& result);
  bool resolveInclude(tinyxml2::XMLElement& include, const std::filesystem::path& file,
                      Prepared& result);
  const Prepared* prepareInclude(const std::string& uri, const std::filesystem::path& file,
                                 const std::string& place);
  void join(const std::filesystem::path& file);
  void requireLoadable(const std::filesystem::path& file, const Prepared& prepared) const;

  const ResourceFinder& finder_;
  Findings& findings_;
  SdfCopies copies_;
  std::optional<std::string> text_;  ///< of the first "file"
  std::map<std::string, Prepared> files_;
  std::vector<MentionedMesh> meshes_;
  std::vector<std::filesystem::path> chain_;  ///< from the world file to the one being read
  std::set<std::pair<std::string, std::string>> reported_;  ///< missing: in which file, which URI
  std::filesystem::path prepared_file_;
  std::unique_ptr<SdfCopies> joined_copies_;
  std::filesystem::path joined_file_;
  bool is_of_gz_ = false;
  bool too_many_ = false;  ///< files multiply one another; then all that draw them in are refused
};

/// The name of the only link of a model that stands in for a missing include, so that what refers
/// to the model remains right. Such models are not part of the world.
inline constexpr const char* kStandInLink = "stand_in_for_missing_include";

}  // namespace synthetic_dataset::world
