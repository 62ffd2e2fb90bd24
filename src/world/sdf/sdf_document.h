#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <sdf/Element.hh>
#include <sdf/Root.hh>

#include "world/files/findings.h"
#include "world/sdf/sdf_copies.h"

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
  /// @param file  for messages
  /// @param prepared_file  what is read in its place: of `copies`, or itself
  SdfDocument(const std::filesystem::path& file, const std::filesystem::path& prepared_file,
              const SdfCopies& copies, Findings& findings);

  /// What `world`, `model` or `light` reads, or null.
  [[nodiscard]] sdf::ElementPtr element() const;

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
