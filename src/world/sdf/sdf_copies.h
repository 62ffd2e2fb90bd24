#pragma once

#include <filesystem>
#include <string>

#include "world/files/scratch_folder.h"

namespace tinyxml2 {
class XMLElement;
}

namespace synthetic_dataset::world {

/// A temporary folder with the SDF files of one world as libsdformat is to read them: includes by
/// the paths of the files that are meant, without those that are missing. A copy lies below the
/// folder at the original's whole path, so that each tells of the other, and has its lines where
/// the original has them.
class SdfCopies {
 public:
  /// @throws Error if the system's folder for temporary files cannot be written
  SdfCopies();

  /// Where the copy of a file lies, or would lie.
  [[nodiscard]] std::filesystem::path copyOf(const std::filesystem::path& original) const;

  /// Writes the element with all that is in it, but for comments.
  /// @throws Error if it cannot be written
  void write(const std::filesystem::path& original, const tinyxml2::XMLElement& root) const;

  /// A message with the paths of copies made those of their originals.
  [[nodiscard]] std::string withOriginalPaths(std::string message) const;

 private:
  ScratchFolder folder_;
};

/// The file of which one is a copy; any other path stays as it is.
[[nodiscard]] std::string originalOf(const std::string& path);

}  // namespace synthetic_dataset::world
