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

/// The part of a mesh file that is requested, and its scale.
struct MeshRequest {
  std::filesystem::path file;
  Eigen::Vector3d scale{1, 1, 1};                    ///< negative factors mirror
  std::string submesh;                               ///< empty: the whole file
  bool centre_submesh = false;                       ///< its bounding box is moved to the origin
  std::optional<std::filesystem::path> animation{};  ///< its first pose is given to the skin
};

/// Triangles with one of the file's own materials.
struct MeshPiece {
  std::shared_ptr<const Mesh> mesh;
  std::size_t material = 0;
};

/// A mesh file that will be needed.
struct MeshAhead {
  std::filesystem::path file;
  bool with_pictures = false;  ///< the pictures of its own materials will be needed, too
};

/// How the note about lines in meshes begins.
inline constexpr const char* kLinesNote = "lines in meshes have no area, and are not drawn: ";

/// Reads each mesh file, picture and material script once, and shares the results.
class MeshLoader {
 public:
  explicit MeshLoader(const ResourceFinder& finder)
      : finder_(finder), textures_(finder), scripts_(finder) {}
  explicit MeshLoader(ResourceFinder&&) = delete;  // it has to outlive this

  /// Reads mesh files that will be needed and have not been read yet, in parallel; errors are
  /// reported when the files are requested.
  void readAhead(const std::vector<MeshAhead>& wanted);

  /// Whether a file has been read, or was found to be unreadable.
  [[nodiscard]] bool knows(const std::filesystem::path& file) const;

  /// The requested triangles, one piece per material.
  /// @throws Error "mesh 'x.dae': <why it cannot be read, or that the submesh is not in it>"
  [[nodiscard]] const std::vector<MeshPiece>& pieces(const MeshRequest& request);

  /// The requested triangles in one piece, for collisions.
  /// @throws Error as `pieces`
  [[nodiscard]] std::shared_ptr<const Mesh> whole(const MeshRequest& request);

  /// The material, with its pictures, of a piece that `pieces` has returned for the same request.
  /// @param missing  called for each picture that is left out because it is missing or cannot be
  ///     decoded
  [[nodiscard]] Material material(const MeshRequest& request, std::size_t index,
                                  const MissingPicture& missing);

  /// Whether such a material stands in for one that the file does not have.
  [[nodiscard]] bool isDefaultMaterial(const std::filesystem::path& file, std::size_t index);

  /// Whether a file that `pieces` has read is COLLADA that declares that y points up.
  [[nodiscard]] bool saysYUp(const std::filesystem::path& file) { return read(file).y_up; }

  /// Notes on what is drawn differently from the requested files, and on Gazebo's pictures for
  /// which stand-ins were painted. Each note is returned once.
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
  std::vector<std::string> with_lines_;  ///< files with lines, since notes were last taken
  std::map<Key, std::vector<MeshPiece>> pieces_;
  std::map<Key, std::shared_ptr<const Mesh>> wholes_;
};

}  // namespace synthetic_dataset::world
