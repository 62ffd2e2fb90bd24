#include "world/mesh/mesh_loader.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <locale>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "base/input_file.h"
#include "base/sandbox/sandboxed_batch.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"
#include "world/mesh/mesh_file.h"
#include "world/mesh/mesh_file_bytes.h"

namespace synthetic_dataset::world {
namespace {

/// Reads many mesh files in parallel, as many at a time as the machine has cores. A process per
/// file would cost more than reading a small file does, so that several files share one.
/// @return those that could be read, by path; for the others, readMeshFile reports what is wrong
std::map<std::string, MeshFile> readMeshFiles(const std::vector<std::filesystem::path>& files) {
  std::vector<base::SandboxedWork> pieces;
  for (const auto& file : files) {
    pieces.push_back({[&file] { return toBytes(importMeshFile(file)); },
                      meshSandboxLimits(file).processor_time});
  }
  const std::vector<std::optional<std::string>> contents =
      base::runAllSandboxed(pieces, base::SandboxLimits().memory);
  std::map<std::string, MeshFile> result;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!contents[i]) continue;
    try {
      MeshFile content = meshFileOf(*contents[i]);
      for (const std::filesystem::path& each : content.files) base::InputWatch::note(each);
      result.emplace(files[i].string(), std::move(content));
    } catch (const Error&) {
      continue;  // it is read again, by itself, when it is needed
    }
  }
  return result;
}

constexpr float kLargestExtent = 1e6F;  // [m]

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

/// The shift that moves the centre of the wanted parts' bounding box to the origin.
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
  to.colours.insert(to.colours.end(), from.colours.begin(), from.colours.end());
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

/// Rejects coordinates beyond what can be drawn or simulated, which come from damaged files and
/// wrong scales.
void checkExtent(const Mesh& mesh) {
  for (const Eigen::Vector3f& position : mesh.positions) {
    const float extent = position.cwiseAbs().maxCoeff();
    if (extent <= kLargestExtent) continue;
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << "reaches " << extent << " m from its origin; at most " << kLargestExtent
         << " m can be drawn: is its scale right?";
    throw Error(text.str());
  }
}

/// Merges parts of the same material into one piece, so that they are drawn together.
std::vector<MeshPiece> makePieces(const MeshFile& file, const MeshRequest& request) {
  const std::vector<const MeshPart*> parts = wantedParts(file, request.submesh);
  const bool centred = request.centre_submesh && !request.submesh.empty();
  const Eigen::Vector3f shift =
      centred ? centring(parts) : Eigen::Vector3f(Eigen::Vector3f::Zero());
  // Material, whether it has texture coordinates, whether it has colours.
  using Kind = std::tuple<std::size_t, bool, bool>;
  std::vector<std::pair<Kind, Mesh>> meshes;
  for (const MeshPart* part : parts) {
    const Kind kind{part->material, !part->mesh.texture_coordinates.empty(),
                    !part->mesh.colours.empty()};
    auto found = std::find_if(meshes.begin(), meshes.end(),
                              [&](const auto& entry) { return entry.first == kind; });
    if (found == meshes.end()) found = meshes.insert(meshes.end(), {kind, Mesh{}});
    append(part->mesh, found->second);
  }
  std::vector<MeshPiece> pieces;
  for (auto& [kind, mesh] : meshes) {
    moveAndScale(shift, request.scale, mesh);
    checkExtent(mesh);
    pieces.push_back({std::make_shared<const Mesh>(std::move(mesh)), std::get<0>(kind)});
  }
  return pieces;
}

/// The pictures of the materials that a file's parts use.
std::vector<TextureReference> picturesOf(const MeshFile& file) {
  std::set<std::size_t> materials;
  for (const MeshPart& part : file.parts) materials.insert(part.material);
  std::vector<TextureReference> pictures;
  for (const std::size_t material : materials) {
    for (const auto* reference : referencesOf(file.materials.at(material))) {
      if (*reference) pictures.push_back(**reference);
    }
  }
  return pictures;
}

/// A skin that is posed by an animation counts as a file of its own.
std::string fileKey(const std::filesystem::path& file,
                    const std::optional<std::filesystem::path>& animation) {
  return file.string() + (animation ? "\n" + animation->string() : "");
}

Error meshError(const std::filesystem::path& file, const std::string& reason) {
  return Error("mesh '" + file.string() + "': " + reason);
}

}  // namespace

MeshLoader::Key MeshLoader::keyOf(const MeshRequest& request) {
  return {fileKey(request.file, request.animation),
          request.submesh,
          request.centre_submesh,
          request.scale.x(),
          request.scale.y(),
          request.scale.z()};
}

void MeshLoader::readAhead(const std::vector<MeshAhead>& wanted) {
  std::map<std::filesystem::path, bool> with_pictures;
  for (const MeshAhead& each : wanted) {
    if (!knows(each.file)) with_pictures[each.file] |= each.with_pictures;
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : with_pictures) files.push_back(entry.first);
  std::vector<TextureReference> pictures;
  for (auto& [path, content] : readMeshFiles(files)) {
    if (with_pictures[path]) {
      for (TextureReference& each : picturesOf(content)) pictures.push_back(std::move(each));
    }
    files_.emplace(path, std::move(content));
  }
  textures_.decodeAhead(pictures);
}

bool MeshLoader::knows(const std::filesystem::path& file) const {
  return files_.count(file.string()) > 0;
}

const MeshFile& MeshLoader::read(const std::filesystem::path& file,
                                 const std::optional<std::filesystem::path>& animation) {
  const std::string key = fileKey(file, animation);
  auto found = files_.find(key);
  if (found == files_.end()) {
    std::variant<MeshFile, std::string> content;
    try {
      content = readMeshFile(file, animation);
    } catch (const Error& error) {
      content = std::string(error.what());
    }
    found = files_.emplace(key, std::move(content)).first;
  }
  if (const auto* reason = std::get_if<std::string>(&found->second)) {
    throw meshError(file, *reason);
  }
  const MeshFile& content = std::get<MeshFile>(found->second);
  if (!content.refusal.empty()) {
    const Error error = meshError(file, content.refusal);
    finder_.refuse(error.what());
    throw error;
  }
  if (wanted_.insert(file.string()).second) {
    for (const std::string& note : content.notes) notes_.emplace_back(meshError(file, note).what());
    if (content.has_lines) with_lines_.push_back(file.string());
  }
  return content;
}

const std::vector<MeshPiece>& MeshLoader::pieces(const MeshRequest& request) {
  const Key key = keyOf(request);
  const auto found = pieces_.find(key);
  if (found != pieces_.end()) return found->second;
  const MeshFile& file = read(request.file, request.animation);
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
  mesh->colours.clear();
  whole = mesh;
  return whole;
}

std::vector<std::string> MeshLoader::takeNotes() {
  std::vector<std::string> notes = std::exchange(notes_, {});
  if (const std::vector<std::string> files = std::exchange(with_lines_, {}); !files.empty()) {
    const std::size_t others = files.size() - 1;
    notes.push_back(kLinesNote + std::string("those of '") + files.front() + "'" +
                    (others == 0 ? "" : " and of " + std::to_string(others) + " others"));
  }
  std::string pictures;
  for (const std::string& picture : textures_.takeStandIns()) {
    pictures += (pictures.empty() ? "'" : ", '") + picture + "'";
  }
  if (!pictures.empty()) {
    notes.push_back("Gazebo's own pictures are not here, and stand-ins were painted for " +
                    pictures +
                    "; install Gazebo, or name its share folder in GAZEBO_RESOURCE_PATH");
  }
  return notes;
}

bool MeshLoader::isDefaultMaterial(const std::filesystem::path& file, std::size_t index) {
  return read(file).materials.at(index).is_default;
}

Material MeshLoader::material(const MeshRequest& request, std::size_t index,
                              const MissingPicture& missing) {
  const MeshFile& file = read(request.file, request.animation);
  return withPictures(file.materials.at(index), textures_, missing);
}

}  // namespace synthetic_dataset::world
