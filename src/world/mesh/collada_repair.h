#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace synthetic_dataset::world {

/// The picture that `withPictureNames` gives to images without one.
constexpr const char* kNoPicture = "no picture";

/// Reads a COLLADA file as XML alone, which Gazebo does with the same library: assimp is more
/// lenient, and hangs or crashes on what is badly formed.
/// @throws Error with the line if it is not XML, or has no COLLADA in it
void checkCollada(const std::filesystem::path& file);

/// The text of a COLLADA file in which every <image> names a picture: assimp refuses a whole file
/// for one that does not, which modellers leave behind and Gazebo takes for no picture.
/// @return nothing where there is nothing to mend
[[nodiscard]] std::optional<std::string> withPictureNames(const std::filesystem::path& file);

}  // namespace synthetic_dataset::world
