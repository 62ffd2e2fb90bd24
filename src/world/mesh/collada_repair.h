#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace synthetic_dataset::world {

/// The picture name that `prepareCollada` gives to images without one.
constexpr const char* kNoPicture = "no picture";

/// A COLLADA file for assimp to read.
struct ColladaText {
  std::optional<std::string> mended;  ///< nothing if the file can be read as it is
  bool y_up = false;                  ///< its `<up_axis>` is Y_UP
};

/// Reads a COLLADA file as XML with the library that Gazebo uses: assimp is more lenient, and hangs
/// or crashes on malformed files. Repairs what Gazebo accepts and assimp (5.2) does not:
///
/// - an `<image>` that names no picture, for which assimp rejects the whole file;
/// - blanks around a text, and comments, which assimp misreads.
///
/// Gazebo applies only the `<matrix>` of a node that has one (ColladaLoader::LoadNodeTransform),
/// while COLLADA applies all transforms. The others are removed.
/// @throws Error with the line if it is not XML, or if it has no COLLADA element
[[nodiscard]] ColladaText prepareCollada(const std::filesystem::path& file);

}  // namespace synthetic_dataset::world
