#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::output {

/// A ROS_PACKAGE_PATH that rospack reads quickly, and as a whole: with the packages of install
/// spaces one by one, in place of the `share` folders that hold them, as rospack looks into every
/// folder below each entry; and without packages whose package.xml cannot be read, for one of which
/// rospack gives up all others.
[[nodiscard]] std::string soundPackagePath(const std::string& package_path);

/// Sets ROS_PACKAGE_PATH to this for this process and those that it starts. Not while other
/// threads run.
void shortenPackageSearch();

/// A writer type that some package declares.
struct WriterType {
  std::string name;  ///< pluginlib's lookup name: "synthetic_dataset/Yolo"
  std::string description;
  std::string package;  ///< that declares it
  std::string problem;  ///< why it cannot be loaded; empty when it can
};

/// Loads writers from plugin libraries. Must outlive what it made.
class WriterLoader {
 public:
  using Instance = std::unique_ptr<LabelWriter, std::function<void(LabelWriter*)>>;

  /// @param plugin_xml_files  where to look; empty: what the packages that ROS knows export
  /// @throws Error when a file is missing, or ROS does not know this package
  explicit WriterLoader(const std::vector<std::string>& plugin_xml_files);
  ~WriterLoader();
  WriterLoader(const WriterLoader&) = delete;
  WriterLoader& operator=(const WriterLoader&) = delete;

  /// @throws Error: there is no such type (with the nearest and all types that there are), or it
  ///     cannot be loaded (why)
  [[nodiscard]] Instance create(const std::string& type);

  /// The names of all declared types.
  [[nodiscard]] std::vector<std::string> typeNames() const;

  /// All declared types, in alphabetical order, each loaded to see whether it can be.
  [[nodiscard]] std::vector<WriterType> types();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::output
