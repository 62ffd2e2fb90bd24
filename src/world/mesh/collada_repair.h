#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace synthetic_dataset::world {

/// The picture that `prepareCollada` gives to images without one.
constexpr const char* kNoPicture = "no picture";

/// A COLLADA file for assimp to read.
struct ColladaText {
  std::optional<std::string> mended;  ///< nothing where the file may be read as it is
  bool y_up = false;                  ///< its `<up_axis>` is Y_UP
};

/// Reads a COLLADA file as XML, which Gazebo does with the same library: assimp is more lenient,
/// and hangs or crashes on what is badly formed. Mends what Gazebo takes and assimp (5.2) does not:
///
/// - an `<image>` that names no picture, for which it refuses the whole file;
/// - blanks around a text, and comments, over which it stumbles.
///
/// Gazebo applies only the `<matrix>` of a node that has one
/// (ColladaLoader::LoadNodeTransform); COLLADA has all of them. The others are taken out.
/// @throws Error with the line if it is not XML, or has no COLLADA in it
[[nodiscard]] ColladaText prepareCollada(const std::filesystem::path& file);

}  // namespace synthetic_dataset::world
