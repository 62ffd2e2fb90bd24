#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "world/description.h"
#include "world/material/material_scripts.h"
#include "world/material/texture_loader.h"
#include "world/mesh/mesh_file.h"

namespace synthetic_dataset::world {

/// Which part of a mesh file is wanted, and how large.
struct MeshRequest {
  std::filesystem::path file;
  Eigen::Vector3d scale{1, 1, 1};                    ///< negative ones mirror
  std::string submesh;                               ///< empty: all of the file
  bool centre_submesh = false;                       ///< its bounding box is moved to the origin
  std::optional<std::filesystem::path> animation{};  ///< whose first pose its skin takes
};

/// Triangles in one of the file's own materials.
struct MeshPiece {
  std::shared_ptr<const Mesh> mesh;
  std::size_t material = 0;
};

/// A mesh file that is going to be wanted.
struct MeshAhead {
  std::filesystem::path file;
  bool with_pictures = false;  ///< those of its own materials are, too
};

/// How the note about lines in meshes begins.
inline constexpr const char* kLinesNote = "lines in meshes have no area, and are not drawn: ";

/// Reads each mesh file, picture and material script once, and shares what was made of them.
class MeshLoader {
 public:
  explicit MeshLoader(const ResourceFinder& finder)
      : finder_(finder), textures_(finder), scripts_(finder) {}
  explicit MeshLoader(ResourceFinder&&) = delete;  // it has to outlive this

  /// Reads mesh files that are going to be wanted and are not known, all at once; faults are
  /// reported when they are.
  void readAhead(const std::vector<MeshAhead>& wanted);

  /// Whether a file has been read, or was found to be unreadable.
  [[nodiscard]] bool knows(const std::filesystem::path& file) const;

  /// The wanted triangles, one piece a material.
  /// @throws Error "mesh 'x.dae': <why it cannot be read, or that the submesh is not in it>"
  [[nodiscard]] const std::vector<MeshPiece>& pieces(const MeshRequest& request);

  /// The wanted triangles in one piece, for collisions.
  /// @throws Error as `pieces`
  [[nodiscard]] std::shared_ptr<const Mesh> whole(const MeshRequest& request);

  /// The material of a piece that `pieces` has given for the same request, with its pictures.
  /// @param missing  called for each picture that is missing or cannot be decoded, and left out
  [[nodiscard]] Material material(const MeshRequest& request, std::size_t index,
                                  const MissingPicture& missing);

  /// Whether such a material stands in for one that the file does not have.
  [[nodiscard]] bool isMadeUp(const std::filesystem::path& file, std::size_t index);

  /// Whether a file that `pieces` has read is COLLADA that says that y points up.
  [[nodiscard]] bool saysYUp(const std::filesystem::path& file) { return read(file).y_up; }

  /// What is drawn otherwise than the files that were wanted would have it, and Gazebo's pictures
  /// that stand-ins were painted for. Each is given once.
  [[nodiscard]] std::vector<std::string> takeNotes();

  [[nodiscard]] TextureLoader& textures() { return textures_; }
  [[nodiscard]] MaterialScripts& scripts() { return scripts_; }

 private:
  /// File and animation, submesh, centred, scale.
  using Key = std::tuple<std::string, std::string, bool, double, double, double>;

  [[nodiscard]] static Key keyOf(const MeshRequest& request);
  [[nodiscard]] const MeshFile& read(
      const std::filesystem::path& file,
      const std::optional<std::filesystem::path>& animation = std::nullopt);

  const ResourceFinder& finder_;
  TextureLoader textures_;
  MaterialScripts scripts_;
  std::map<std::string, std::variant<MeshFile, std::string>> files_;  ///< or why it is unreadable
  std::set<std::string> wanted_;  ///< files whose notes have been gathered
  std::vector<std::string> notes_;
  std::vector<std::string> with_lines_;  ///< files, since notes were taken
  std::map<Key, std::vector<MeshPiece>> pieces_;
  std::map<Key, std::shared_ptr<const Mesh>> wholes_;
};

}  // namespace synthetic_dataset::world
