#pragma once

#include <filesystem>
#include <string>

#include <sdf/Element.hh>
#include <sdf/Root.hh>

#include "world/findings.h"
#include "world/include_graph.h"

namespace sdf {
inline namespace SDF_VERSION_NAMESPACE {
class Light;
class Model;
class World;
}  // namespace SDF_VERSION_NAMESPACE
}  // namespace sdf

/// The place where differences between the versions of libsdformat live.
namespace synthetic_dataset::world {

/// A world or model file as libsdformat reads it, which prints nothing meanwhile.
class SdfDocument {
 public:
  /// What libsdformat finds wrong becomes an error, but for what Gazebo shows nevertheless.
  SdfDocument(const std::filesystem::path& file, const IncludeGraph& includes, Findings& findings);

  /// The file's first world, or nothing.
  [[nodiscard]] const sdf::World* world() const;

  /// What a file without a world has, or nothing.
  [[nodiscard]] const sdf::Model* model() const;
  [[nodiscard]] const sdf::Light* light() const;

  /// Whether libsdformat had no complaints; otherwise poses may be unknown for reasons already
  /// told.
  [[nodiscard]] bool isSound() const { return sound_; }

 private:
  sdf::Root root_;
  bool sound_ = true;
};

/// The file that an element comes from, or an empty string.
[[nodiscard]] std::string fileOf(const sdf::ElementPtr& element);

/// Whether an element stands in the file; libsdformat adds required ones that do not.
[[nodiscard]] bool isInFile(const sdf::ElementPtr& element);

/// What libsdformat says of an error, with file and line where it knows them.
[[nodiscard]] std::string describe(const sdf::Error& error, const std::string& file);

}  // namespace synthetic_dataset::world
