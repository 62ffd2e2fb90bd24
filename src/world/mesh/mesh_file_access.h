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

/// Controls which files assimp may open for a mesh file, and what it reads from them.
///
/// - Only regular files: opening a pipe or a device may block for ever.
/// - For a glTF file, only files that belong to its own model: below the nearest folder that has a
///   model.config or a package.xml, else below the file's own (glTF 2.0, section 2.9: URIs should
///   not lead to other folders).
/// - The text of OBJ and MTL files is repaired for it first (`repairedObj`, `repairedMtl`).
class MeshFileAccess {
 public:
  explicit MeshFileAccess(std::filesystem::path file);

  /// The I/O system for assimp. It refers to this object; the caller has to delete it.
  [[nodiscard]] Assimp::IOSystem* makeIoSystem();

  /// Makes assimp read this text instead of the mesh file's own.
  void replace(std::string text) { texts_[file_.string()] = std::move(text); }

  /// Why the mesh file cannot be read as a whole: something that it names is not a regular file.
  /// Nothing if there is no such fault.
  [[nodiscard]] const std::optional<std::string>& fault() const { return fault_; }

  /// Which file the mesh file names that it must not name; nothing if there is none.
  [[nodiscard]] const std::optional<std::string>& refusal() const { return refusal_; }

  /// Refuses the mesh file if this picture must not be read.
  /// @param uri  as written in the mesh file
  void checkPicture(const std::string& uri);

  /// The material libraries that an OBJ file names but that do not exist.
  [[nodiscard]] std::vector<std::string> missingLibraries() const;

  /// All files that assimp has asked for, including those that do not exist.
  [[nodiscard]] const std::set<std::filesystem::path>& askedFor() const { return asked_for_; }

  /// The materials that the libraries read so far define.
  [[nodiscard]] const std::set<std::string>& libraryMaterials() const { return materials_; }

 private:
  class IoSystem;

  /// Whether assimp may open a file.
  [[nodiscard]] bool allows(const std::filesystem::path& file);

  /// The text that assimp is given instead of a file's content, or null if it reads the file
  /// itself.
  [[nodiscard]] const std::string* textOf(const std::filesystem::path& file);

  std::filesystem::path file_;
  std::optional<std::filesystem::path> root_;  ///< the folder that all files have to be below
  std::map<std::string, std::string> texts_;
  std::set<std::filesystem::path> asked_for_;
  std::optional<std::string> fault_;
  std::optional<std::string> refusal_;
  std::vector<std::string> libraries_;  ///< that an OBJ file names
  std::set<std::string> materials_;
};

}  // namespace synthetic_dataset::world
