#include "world/mesh_loader.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::world {
namespace {

bool isCalled(const MeshPart& part, const std::string& name) {
  return std::find(part.names.begin(), part.names.end(), name) != part.names.end();
}

std::vector<std::string> partNames(const MeshFile& file) {
  std::vector<std::string> names;
  for (const MeshPart& part : file.parts) {
    for (const std::string& name : part.names) {
      if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) {
        names.push_back(name);
      }
    }
  }
  return names;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text.empty() ? "none with a name" : text;
}

std::vector<const MeshPart*> wantedParts(const MeshFile& file, const std::string& submesh) {
  std::vector<const MeshPart*> wanted;
  for (const MeshPart& part : file.parts) {
    if (submesh.empty() || isCalled(part, submesh)) wanted.push_back(&part);
  }
  if (wanted.empty()) {
    const std::vector<std::string> names = partNames(file);
    throw Error("has no submesh '" + submesh + "' (it has " + listed(names) + ")" +
                didYouMean(submesh, names));
  }
  return wanted;
}

/// What brings the wanted parts' bounding box to the origin.
Eigen::Vector3f centring(const std::vector<const MeshPart*>& parts) {
  Eigen::AlignedBox3f bounds;
  for (const MeshPart* part : parts) {
    for (const Eigen::Vector3f& position : part->mesh.positions) bounds.extend(position);
  }
  return -bounds.center();
}

void append(const Mesh& from, Mesh& to) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
  to.normals.insert(to.normals.end(), from.normals.begin(), from.normals.end());
  to.texture_coordinates.insert(to.texture_coordinates.end(), from.texture_coordinates.begin(),
                                from.texture_coordinates.end());
  for (const std::uint32_t index : from.indices) to.indices.push_back(first + index);
}

void moveAndScale(const Eigen::Vector3f& shift, const Eigen::Vector3d& scale, Mesh& mesh) {
  for (Eigen::Vector3f& position : mesh.positions) {
    position = (position + shift).cast<double>().cwiseProduct(scale).cast<float>();
  }
  for (Eigen::Vector3f& normal : mesh.normals) {
    normal = normal.cast<double>().cwiseQuotient(scale).normalized().cast<float>();
  }
  if (scale.prod() > 0.0) return;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  }
}

/// Parts of the same material become one piece, so that they are drawn in one go.
std::vector<MeshPiece> makePieces(const MeshFile& file, const MeshRequest& request) {
  const std::vector<const MeshPart*> parts = wantedParts(file, request.submesh);
  const bool centred = request.centre_submesh && !request.submesh.empty();
  const Eigen::Vector3f shift =
      centred ? centring(parts) : Eigen::Vector3f(Eigen::Vector3f::Zero());
  using Kind = std::pair<std::size_t, bool>;  // material, with texture coordinates
  std::vector<std::pair<Kind, Mesh>> meshes;
  for (const MeshPart* part : parts) {
    const Kind kind{part->material, !part->mesh.texture_coordinates.empty()};
    auto found = std::find_if(meshes.begin(), meshes.end(),
                              [&](const auto& entry) { return entry.first == kind; });
    if (found == meshes.end()) found = meshes.insert(meshes.end(), {kind, Mesh{}});
    append(part->mesh, found->second);
  }
  std::vector<MeshPiece> pieces;
  for (auto& [kind, mesh] : meshes) {
    moveAndScale(shift, request.scale, mesh);
    pieces.push_back({std::make_shared<const Mesh>(std::move(mesh)), kind.first});
  }
  return pieces;
}

Error meshError(const std::filesystem::path& file, const std::string& reason) {
  return Error("mesh '" + file.string() + "': " + reason);
}

}  // namespace

MeshLoader::Key MeshLoader::keyOf(const MeshRequest& request) {
  return {request.file.string(), request.submesh,   request.centre_submesh,
          request.scale.x(),     request.scale.y(), request.scale.z()};
}

const MeshFile& MeshLoader::read(const std::filesystem::path& file) {
  auto found = files_.find(file.string());
  if (found == files_.end()) {
    std::variant<MeshFile, std::string> content;
    try {
      content = readMeshFile(file);
    } catch (const Error& error) {
      content = std::string(error.what());
    }
    found = files_.emplace(file.string(), std::move(content)).first;
  }
  if (const auto* reason = std::get_if<std::string>(&found->second)) {
    throw meshError(file, *reason);
  }
  return std::get<MeshFile>(found->second);
}

const std::vector<MeshPiece>& MeshLoader::pieces(const MeshRequest& request) {
  const Key key = keyOf(request);
  const auto found = pieces_.find(key);
  if (found != pieces_.end()) return found->second;
  const MeshFile& file = read(request.file);
  try {
    return pieces_.emplace(key, makePieces(file, request)).first->second;
  } catch (const Error& error) {
    throw meshError(request.file, error.what());
  }
}

std::shared_ptr<const Mesh> MeshLoader::whole(const MeshRequest& request) {
  const std::vector<MeshPiece>& parts = pieces(request);
  if (parts.size() == 1) return parts.front().mesh;
  auto& whole = wholes_[keyOf(request)];
  if (whole) return whole;
  auto mesh = std::make_shared<Mesh>();
  for (const MeshPiece& part : parts) append(*part.mesh, *mesh);
  mesh->texture_coordinates.clear();
  whole = mesh;
  return whole;
}

Material MeshLoader::material(const std::filesystem::path& file, std::size_t index) {
  const MeshMaterial& from = read(file).materials.at(index);
  Material material = from.material;
  if (from.texture) material.texture = textures_.load(*from.texture);
  return material;
}

}  // namespace synthetic_dataset::world
