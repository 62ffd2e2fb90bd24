#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::output {

/// A ROS_PACKAGE_PATH that rospack reads quickly and completely. Packages of install spaces are
/// listed one by one instead of by the `share` folder that contains them, since rospack searches
/// every folder below each entry. Packages with an unreadable package.xml are left out, since a
/// single one makes rospack give up on all others.
[[nodiscard]] std::string soundPackagePath(const std::string& package_path);

/// Sets ROS_PACKAGE_PATH to that path for this process and its children. Must not be called while
/// other threads run.
void shortenPackageSearch();

/// A writer type declared by some package.
struct WriterType {
  std::string name;  ///< pluginlib's lookup name: "synthetic_dataset/Yolo"
  std::string description;
  std::string package;  ///< the one that declares it
  std::string problem;  ///< why it cannot be loaded; empty if it can
};

/// Loads writers from plugin libraries. Must outlive the writers it made.
class WriterLoader {
 public:
  using Instance = std::unique_ptr<LabelWriter, std::function<void(LabelWriter*)>>;

  /// @param plugin_xml_files  where to look; empty for what all packages known to ROS export
  /// @throws Error if a file is missing, or ROS does not know this package
  explicit WriterLoader(const std::vector<std::string>& plugin_xml_files);
  ~WriterLoader();
  WriterLoader(const WriterLoader&) = delete;
  WriterLoader& operator=(const WriterLoader&) = delete;

  /// @throws Error if there is no such type (naming the nearest and all available types), or it
  ///     cannot be loaded (saying why)
  [[nodiscard]] Instance create(const std::string& type);

  /// The names of all declared types.
  [[nodiscard]] std::vector<std::string> typeNames() const;

  /// All declared types in alphabetical order, each loaded to see whether that works.
  [[nodiscard]] std::vector<WriterType> types();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::output
