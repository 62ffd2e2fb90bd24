#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace synthetic_dataset::world {

/// Whether a path is in a folder, or is that folder, judged by the names only: `..` is resolved,
/// symbolic links are not.
[[nodiscard]] bool isWithin(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Folders that ROS packages export for Gazebo in their package.xml:
/// `<export><gazebo_ros gazebo_model_path="..." gazebo_media_path="..."/></export>`.
struct ExportedFolders {
  std::vector<std::string> models;  ///< like those in GAZEBO_MODEL_PATH
  std::vector<std::string> media;   ///< like those in GAZEBO_RESOURCE_PATH
};

/// Finds the files that worlds and models name by URI, as Gazebo's SystemPaths and sdformat's
/// findFile do. The network is never used.
///
/// - `model://name/rest`: in the folders given to the constructor, then those of GAZEBO_MODEL_PATH,
///   GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH and SDF_PATH, in this order, then in
///   ~/.gazebo/models, where Gazebo keeps what it has downloaded, and in the models of an installed
///   Gazebo, then in the ROS package `name` (libsdformat rewrites the `package://` of URDF files to
///   `model://`), then, if the file with the URI belongs to a model of this name, in that model;
/// - `package://name/rest`: in the ROS package, then as `model://`;
/// - `https://fuel.gazebosim.org/1.0/owner/models/name` and the like: in the caches of Gazebo's
///   tools (see fuel.h);
/// - `file://path`, paths and names: relative to the folder of the file that names them; then in
///   the folders of GAZEBO_RESOURCE_PATH and of an installed Gazebo, each also below `models/`,
///   `media/models/` and `Media/models/`; then in the folders that are searched for models;
/// - absolute paths: as they are.
///
/// Files that are not found there are looked for in the folders that ROS packages export. Each URI
/// is tried as it is, then with its percent escapes decoded, then with the backslashes of Windows
/// replaced by slashes.
///
/// `..` never leads out of a folder that is searched: `model://name/../../file` is refused
/// (`leadsOut`). Only the neighbours of a package may be named: `package://name/../other/file`.
class ResourceFinder {
 public:
  /// Returns the folder of a ROS package, or nothing.
  using PackageFinder = std::function<std::optional<std::string>(const std::string& package)>;

  /// Returns the folders that ROS packages export. Called when something is not found elsewhere.
  using ExportFinder = std::function<ExportedFolders()>;

  /// @param model_folders  folders that hold models, searched before those of the environment
  ResourceFinder(std::vector<std::string> model_folders, PackageFinder package_finder,
                 ExportFinder export_finder = nullptr);

  /// The file (or folder) to which `uri` refers in a file in `folder`, or nothing if there is none.
  [[nodiscard]] std::optional<std::filesystem::path> find(
      const std::string& uri, const std::filesystem::path& folder) const;

  /// The file (or folder) at a known path, recorded as `find` does; nothing if there is none.
  [[nodiscard]] std::optional<std::filesystem::path> at(const std::filesystem::path& path) const;

  /// The folders of GAZEBO_RESOURCE_PATH and of an installed Gazebo, and those that ROS packages
  /// export as Gazebo's media.
  [[nodiscard]] std::vector<std::string> mediaFolders() const;

  /// The files found so far.
  [[nodiscard]] const std::set<std::filesystem::path>& found() const { return found_; }

  /// The paths tried so far at which there was nothing.
  [[nodiscard]] const std::set<std::filesystem::path>& missed() const { return missed_; }

  /// The URIs for which nothing was found so far.
  [[nodiscard]] const std::set<std::string>& unresolved() const { return unresolved_; }

  /// Where `find` looks for the URI, for messages: "looked in a, b, c".
  [[nodiscard]] std::string searchedPlaces(const std::string& uri,
                                           const std::filesystem::path& folder) const;

  /// Whether a URI would lead out of the folders to which it may refer; `find` does not go there.
  [[nodiscard]] bool leadsOut(const std::string& uri, const std::filesystem::path& folder) const;

  /// Records that a file names another that it must not name. No dataset is made of such a world,
  /// even if files may be missing.
  void refuse(const std::string& message) const { refusals_.insert(message); }

  /// Messages about the URIs looked up so far that lead out of the folders to which they may refer,
  /// and those given to `refuse`.
  [[nodiscard]] const std::set<std::string>& refusals() const { return refusals_; }

 private:
  /// "; did you mean 'x'?", naming a file next to those to which a URI may refer, or an empty text.
  [[nodiscard]] std::string nearMiss(const std::string& uri,
                                     const std::filesystem::path& folder) const;

  struct Candidates;

  /// The candidates for a URI in one spelling.
  [[nodiscard]] Candidates candidates(const std::string& uri,
                                      const std::filesystem::path& folder) const;
  /// Candidates in exported folders, which are searched last.
  [[nodiscard]] Candidates exportedCandidates(const std::string& uri) const;

  static void addModel(const std::string& rest, const std::vector<std::string>& folders,
                       Candidates& to);
  void addPackage(const std::string& rest, Candidates& to) const;
  static void addPlain(const std::string& rest, const std::vector<std::string>& media,
                       const std::vector<std::string>& models, Candidates& to);

  /// The package that a URI names, if ROS does not know it.
  [[nodiscard]] std::optional<std::string> unknownPackage(const std::string& uri) const;

  std::vector<std::string> model_folders_;
  std::vector<std::string> media_folders_;
  std::vector<std::filesystem::path> fuel_caches_;
  PackageFinder package_finder_;
  ExportFinder export_finder_;
  mutable std::set<std::filesystem::path> found_;   ///< only a record: no result depends on it
  mutable std::set<std::filesystem::path> missed_;  ///< only a record
  mutable std::set<std::string> unresolved_;        ///< only a record
  mutable std::set<std::string> refusals_;          ///< only a record
};

}  // namespace synthetic_dataset::world
