#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace Assimp {
class IOSystem;
}

namespace synthetic_dataset::world {

/// Which files assimp may open for a mesh file, and what it gets to read.
///
/// - Nothing but regular files: opening a pipe or a device may never end.
/// - For a glTF file, only files of its own model: below the nearest folder that has a model.config
///   or a package.xml, else below the file's own (glTF 2.0, section 2.9: URIs should not lead to
///   other folders).
/// - OBJ and MTL files are given to it as it understands them (`repairedObj`, `repairedMtl`).
class MeshFileAccess {
 public:
  explicit MeshFileAccess(std::filesystem::path file);

  /// What assimp opens files with. It refers to this object, and is the caller's to delete.
  [[nodiscard]] Assimp::IOSystem* makeIoSystem();

  /// Gives assimp another text in the file's place.
  void replace(std::string text) { texts_[file_.string()] = std::move(text); }

  /// Why the file cannot be read as a whole; nothing where all that was opened may be.
  [[nodiscard]] const std::optional<std::string>& fault() const { return fault_; }

  /// What the file names and may not; nothing where it names no such file.
  [[nodiscard]] const std::optional<std::string>& refusal() const { return refusal_; }

  /// Refuses a picture that may not be read.
  /// @param uri  as a glTF file has it
  void checkPicture(const std::string& uri);

  /// The material libraries that an OBJ file names and that are not there.
  [[nodiscard]] std::vector<std::string> missingLibraries() const;

  /// All files that assimp has asked for, also those that are not there.
  [[nodiscard]] const std::set<std::filesystem::path>& askedFor() const { return asked_for_; }

  /// The materials that the libraries read so far define.
  [[nodiscard]] const std::set<std::string>& libraryMaterials() const { return materials_; }

 private:
  class IoSystem;

  /// Whether assimp may open a file.
  [[nodiscard]] bool allows(const std::filesystem::path& file);

  /// The text that assimp is given in a file's place, or null where it reads the file itself.
  [[nodiscard]] const std::string* textOf(const std::filesystem::path& file);

  std::filesystem::path file_;
  std::optional<std::filesystem::path> root_;  ///< that all files have to be below
  std::map<std::string, std::string> texts_;
  std::set<std::filesystem::path> asked_for_;
  std::optional<std::string> fault_;
  std::optional<std::string> refusal_;
  std::vector<std::string> libraries_;  ///< that an OBJ file names
  std::set<std::string> materials_;
};

}  // namespace synthetic_dataset::world
