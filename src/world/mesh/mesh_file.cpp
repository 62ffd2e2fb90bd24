#include "world/mesh/mesh_file.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <fstream>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <variant>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <Eigen/Geometry>
#include <assimp/Importer.hpp>

#include "base/input_file.h"
#include "base/sandbox/sandboxed_process.h"
#include "synthetic_dataset/errors.h"
#include "world/material/material_conversions.h"
#include "world/mesh/assimp_conversions.h"
#include "world/mesh/assimp_gaps.h"
#include "world/mesh/collada_repair.h"
#include "world/mesh/mesh_file_access.h"
#include "world/mesh/mesh_file_bytes.h"
#include "world/mesh/mesh_materials.h"
#include "world/mesh/mesh_normals.h"
#include "world/mesh/mesh_pictures.h"
#include "world/mesh/skin_pose.h"

namespace synthetic_dataset::world {
namespace {

/// Where faces meet at a sharper angle than this, generated normals keep the edge [deg].
constexpr float kCreaseAngle = 45.0F;

void configure(Assimp::Importer& importer) {
  // Gazebo does not parse <up_axis> (gazebo-classic issue 1305; gz-common drops the root's
  // rotation), and neither does rviz, so existing models are made for that.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  // <submesh> refers to the names that the modeller sees, not to the file's identifiers.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT);
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kCreaseAngle);
}

/// assimp (5.2) does not check indices for all formats, and its processing steps would read beyond
/// the vertices.
void checkIndices(const aiScene& scene) {
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[i];
    for (unsigned face = 0; face < mesh.mNumFaces; ++face) {
      const aiFace& corners = mesh.mFaces[face];
      for (unsigned corner = 0; corner < corners.mNumIndices; ++corner) {
        if (corners.mIndices[corner] < mesh.mNumVertices) continue;
        throw Error("has a face with vertex " + std::to_string(corners.mIndices[corner]) +
                    " (counted from 0) of " + std::to_string(mesh.mNumVertices));
      }
    }
  }
}

/// @return null, with a reason, for a file that cannot be read
const aiScene* tryImport(Assimp::Importer& importer, const std::filesystem::path& file,
                         std::string& reason) {
  constexpr unsigned kSteps = aiProcess_Triangulate | aiProcess_SortByPType |
                              aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices |
                              aiProcess_FlipUVs;
  try {
    const aiScene* scene = importer.ReadFile(file.string(), 0);
    if (scene != nullptr) {
      checkIndices(*scene);
      scene = importer.ApplyPostProcessing(kSteps);
    }
    reason = importer.GetErrorString();
    return scene;
  } catch (const std::exception& error) {
    reason = error.what();
    return nullptr;
  }
}

/// assimp (5.2) never stops reading a PLY file whose header does not end.
void checkPly(const std::filesystem::path& file) {
  std::ifstream stream = base::openInput(file);
  std::string line;
  while (std::getline(stream, line)) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    if (line == "end_header") return;
  }
  throw Error("cannot be read: its header has no line 'end_header'");
}

/// @return null for a file that names another that it must not name
const aiScene* import(Assimp::Importer& importer, const std::filesystem::path& file,
                      MeshFileAccess& access) {
  configure(importer);
  importer.SetIOHandler(access.makeIoSystem());
  std::string reason;
  const aiScene* scene = tryImport(importer, file, reason);
  if (access.refusal()) return nullptr;
  if (access.fault()) throw Error(*access.fault());
  if (scene == nullptr && reason.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw Error("cannot be read (" + reason + ")");
  }
  return scene;
}

/// The texture coordinates that the material's picture uses, else the first ones.
const aiVector3D* textureCoordinates(const aiMesh& mesh, unsigned channel) {
  if (channel < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(channel)) {
    return mesh.mTextureCoords[channel];
  }
  return mesh.HasTextureCoords(0) ? mesh.mTextureCoords[0] : nullptr;
}

/// glTF's colours are linear (glTF 2.0, section 3.7.2.1); those of all other formats are shown as
/// they are.
void copyColours(const aiMesh& from, bool linear, Mesh& to) {
  const aiColor4D* colours = from.mColors[0];
  if (colours == nullptr) return;
  to.colours.reserve(from.mNumVertices);
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    Eigen::Vector4f colour(colours[i].r, colours[i].g, colours[i].b, colours[i].a);
    if (!colour.allFinite()) throw Error("has a vertex colour that is not a number");
    colour = colour.cwiseMax(0.0F).cwiseMin(1.0F);
    if (linear) colour.head<3>() = colour.head<3>().unaryExpr(&encodedComponent).eval();
    to.colours.push_back(colour);
  }
  // assimp (5.2) gives glTF's colours without alpha an alpha of 0.
  const auto has_no_alpha = [](const Eigen::Vector4f& colour) { return colour.w() == 0.0F; };
  if (std::all_of(to.colours.begin(), to.colours.end(), has_no_alpha)) {
    for (Eigen::Vector4f& colour : to.colours) colour.w() = 1.0F;
  }
  const auto is_white = [](const Eigen::Vector4f& colour) { return colour.isOnes(); };
  if (std::all_of(to.colours.begin(), to.colours.end(), is_white)) to.colours.clear();
}

/// @param posed  the transform of each vertex, of a mesh that a skeleton moves, instead of `node`;
///     else empty
void copyVertices(const aiMesh& from, const Eigen::Affine3d& node,
                  const std::vector<Eigen::Affine3d>& posed, unsigned channel, Mesh& to) {
  to.positions.reserve(from.mNumVertices);
  to.normals.reserve(from.mNumVertices);
  Eigen::Matrix3d turn = node.linear().inverse().transpose();
  const aiVector3D* coordinates = textureCoordinates(from, channel);
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    const aiVector3D& p = from.mVertices[i];
    const Eigen::Affine3d& transform = posed.empty() ? node : posed[i];
    if (!posed.empty()) turn = transform.linear().inverse().transpose();
    const Eigen::Vector3f position = (transform * Eigen::Vector3d(p.x, p.y, p.z)).cast<float>();
    if (!position.allFinite()) throw Error("has a vertex that is not a number");
    to.positions.push_back(position);
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    if (from.HasNormals()) {
      const aiVector3D& n = from.mNormals[i];
      normal = turn * Eigen::Vector3d(n.x, n.y, n.z);
    }
    to.normals.push_back(normal.cast<float>());
    if (coordinates != nullptr) {
      to.texture_coordinates.emplace_back(coordinates[i].x, coordinates[i].y);
    }
  }
}

void copyTriangles(const aiMesh& from, bool mirrored, Mesh& to) {
  to.indices.reserve(3 * std::size_t{from.mNumFaces});
  for (unsigned i = 0; i < from.mNumFaces; ++i) {
    const aiFace& face = from.mFaces[i];
    if (face.mNumIndices != 3) continue;
    to.indices.push_back(face.mIndices[0]);
    to.indices.push_back(face.mIndices[mirrored ? 2 : 1]);
    to.indices.push_back(face.mIndices[mirrored ? 1 : 2]);
  }
}

/// Gazebo names a submesh after the nearest node that has a name.
std::string nodeName(const aiNode* node) {
  for (; node != nullptr; node = node->mParent) {
    const std::string name = node->mName.C_Str();
    if (!name.empty() && name.rfind("$ColladaAutoName$", 0) != 0) return name;
  }
  return "";
}

/// Reads a scene's nodes into parts.
struct SceneReader {
  const aiScene& scene;
  const std::vector<unsigned>& channels;  ///< of texture coordinates, one per material
  bool linear_colours;
  const SkinPose* pose;  ///< null: skins stay as modelled
  std::vector<MeshPart> parts;

  void read(const aiNode& node, const Eigen::Affine3d& parent) {
    const Eigen::Affine3d transform = parent * affineOf(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
      MeshPart part;
      part.names = {nodeName(&node), mesh.mName.C_Str()};
      part.material = mesh.mMaterialIndex;
      copyTriangles(mesh, transform.linear().determinant() < 0.0, part.mesh);
      if (part.mesh.indices.empty()) continue;
      const auto posed =
          pose != nullptr ? pose->displacements(mesh) : std::vector<Eigen::Affine3d>{};
      copyVertices(mesh, transform, posed, channels.at(part.material), part.mesh);
      copyColours(mesh, linear_colours, part.mesh);
      completeNormals(part.mesh);
      parts.push_back(std::move(part));
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) read(*node.mChildren[i], transform);
  }
};

bool hasLines(const aiScene& scene) {
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    if ((scene.mMeshes[i]->mPrimitiveTypes & aiPrimitiveType_LINE) != 0) return true;
  }
  return false;
}

/// Makes a default material white if the vertices have colours, so that only those count.
void whitenMadeUp(MeshFile& result) {
  for (const MeshPart& part : result.parts) {
    MaterialSource& source = result.materials[part.material];
    if (source.is_default && !part.mesh.colours.empty()) source.material.diffuse.setOnes();
  }
}

/// Whether a library defines the material: for other names in an OBJ file, assimp makes one up.
bool isDefined(const aiMaterial& material, const MeshFileAccess& access) {
  aiString name;
  return material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS &&
         access.libraryMaterials().count(name.C_Str()) > 0;
}

std::vector<MaterialSource> readMaterials(const aiScene& scene, const std::filesystem::path& file,
                                          MeshFileAccess& access) {
  std::vector<MaterialSource> materials;
  MeshPictures pictures(scene, file);
  const bool has_library = extensionOf(file) == ".obj";
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    const aiMaterial& material = *scene.mMaterials[i];
    materials.push_back(readMaterial(material, file, pictures));
    if (has_library && !isDefined(material, access)) {
      materials.back() = MaterialSource{};
      materials.back().is_default = true;
    }
    for (const auto* reference : referencesOf(materials.back())) {
      if (*reference && !(*reference)->embedded) access.checkPicture((*reference)->uri);
    }
  }
  return materials;
}

/// Notes on missing material libraries, if something that is drawn lacks their materials.
std::vector<std::string> notesOn(const MeshFile& file, const MeshFileAccess& access) {
  const auto lacks = [&](const MeshPart& part) { return file.materials[part.material].is_default; };
  if (std::none_of(file.parts.begin(), file.parts.end(), lacks)) return {};
  std::vector<std::string> notes;
  for (const std::string& library : access.missingLibraries()) {
    notes.push_back("its material library '" + library +
                    "' is not there; drawn without its materials");
  }
  return notes;
}

/// The pose is copied from the animation's file, which is not kept.
std::optional<SkinPose> poseOf(const aiScene& skin,
                               const std::optional<std::filesystem::path>& animation) {
  if (!animation) return std::nullopt;
  MeshFileAccess access(*animation);
  Assimp::Importer importer;
  const aiScene* scene = import(importer, *animation, access);
  if (scene == nullptr) throw Error(*access.refusal());
  return SkinPose(skin, *scene);
}

}  // namespace

base::SandboxLimits meshSandboxLimits(const std::filesystem::path& file) {
  base::SandboxLimits limits;
  // A glTF file's size says nothing: its data is in other files.
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  if (unknown || extensionOf(file) == ".gltf") return limits;
  constexpr std::uintmax_t kBytesPerSecond = 250000;
  const auto seconds = static_cast<std::chrono::seconds::rep>(10 + size / kBytesPerSecond);
  limits.processor_time = std::min(limits.processor_time, std::chrono::seconds(seconds));
  return limits;
}

MeshFile importMeshFile(const std::filesystem::path& file,
                        const std::optional<std::filesystem::path>& animation) {
  const std::string extension = extensionOf(file);
  MeshFileAccess access(file);
  MeshFile result;
  if (extension == ".dae") {
    ColladaText text = prepareCollada(file);
    result.y_up = text.y_up;
    if (text.mended) access.replace(std::move(*text.mended));
  }
  if (extension == ".ply") checkPly(file);
  Assimp::Importer importer;
  const aiScene* scene = import(importer, file, access);
  if (scene != nullptr) result.materials = readMaterials(*scene, file, access);
  if (access.refusal()) {
    MeshFile refused;
    refused.refusal = *access.refusal();
    return refused;
  }
  std::vector<unsigned> channels;
  for (unsigned i = 0; i < scene->mNumMaterials; ++i) {
    channels.push_back(textureChannel(*scene->mMaterials[i]));
  }
  const std::optional<SkinPose> pose = poseOf(*scene, animation);
  SceneReader reader{
      *scene, channels, extension == ".gltf" || extension == ".glb", pose ? &*pose : nullptr, {}};
  reader.read(*scene->mRootNode, Eigen::Affine3d::Identity());
  if (reader.parts.empty()) throw Error("has no triangles");
  result.parts = std::move(reader.parts);
  result.has_lines = hasLines(*scene);
  result.notes = notesOn(result, access);
  result.files.assign(access.askedFor().begin(), access.askedFor().end());
  removeUnreliableData(file, result);
  whitenMadeUp(result);
  return result;
}

MeshFile readMeshFile(const std::filesystem::path& file,
                      const std::optional<std::filesystem::path>& animation) {
  const auto work = [&] { return toBytes(importMeshFile(file, animation)); };
  const std::variant<std::string, base::Crash> answer =
      base::runSandboxed(work, meshSandboxLimits(file));
  if (const auto* crash = std::get_if<base::Crash>(&answer)) {
    throw Error("cannot be read (assimp, which reads it, " + crash->how + ")");
  }
  MeshFile content = meshFileOf(std::get<std::string>(answer));
  for (const std::filesystem::path& each : content.files) base::InputWatch::note(each);
  return content;
}

}  // namespace synthetic_dataset::world
