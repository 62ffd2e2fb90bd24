#include "world/mesh/mesh_file_access.h"

#include <cstdint>
#include <system_error>
#include <utility>

#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>

#include "base/input_file.h"
#include "world/files/fuel.h"
#include "world/files/resource_finder.h"
#include "world/files/text.h"
#include "world/mesh/mesh_materials.h"
#include "world/mesh/obj_repair.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

bool isGltf(const fs::path& file) {
  const std::string extension = extensionOf(file);
  return extension == ".gltf" || extension == ".glb";
}

/// The folder of the model or package that a file belongs to, else its own.
fs::path modelRootOf(const fs::path& file) {
  const fs::path own = fs::absolute(file).lexically_normal().parent_path();
  for (fs::path folder = own; folder.has_relative_path(); folder = folder.parent_path()) {
    std::error_code ignored;
    for (const char* mark : {"model.config", "package.xml"}) {
      if (fs::is_regular_file(folder / mark, ignored)) return folder;
    }
  }
  return own;
}

}  // namespace

class MeshFileAccess::IoSystem : public Assimp::DefaultIOSystem {
 public:
  explicit IoSystem(MeshFileAccess& access) : access_(access) {}

  /// The base class would open the file, which may block for ever.
  bool Exists(const char* path) const override { return access_.allows(path); }

  Assimp::IOStream* Open(const char* path, const char* mode) override {
    access_.asked_for_.insert(path);
    if (!access_.allows(path)) return nullptr;
    const std::string* text = access_.textOf(path);
    if (text == nullptr) return DefaultIOSystem::Open(path, mode);
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(text->data()),
                                      text->size());  // assimp deletes it
  }

 private:
  MeshFileAccess& access_;
};

MeshFileAccess::MeshFileAccess(fs::path file) : file_(std::move(file)) {
  if (isGltf(file_)) root_ = modelRootOf(file_);
}

Assimp::IOSystem* MeshFileAccess::makeIoSystem() { return new IoSystem(*this); }

bool MeshFileAccess::allows(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (root_ && file != file_ && !isWithin(file, *root_)) {
    refusal_ = "names the file '" + file.string() + "', which is not below " + root_->string() +
               ", and is not read";
    return false;
  }
  if (!fs::exists(status)) {
    return false;
  }
  if (fs::is_regular_file(status)) return true;
  if (!fault_) {
    fault_ = "names '" + file.string() + "', which " + base::inputFault(file);
  }
  return false;
}

const std::string* MeshFileAccess::textOf(const fs::path& file) {
  const auto known = texts_.find(file.string());
  if (known != texts_.end()) return &known->second;
  const std::string extension = extensionOf(file);
  std::optional<std::string> text;
  if (extension == ".obj") {
    text = repairedObj(base::readInput(file));
    libraries_ = librariesOfObj(*text);
  }
  if (extension == ".mtl") {
    text = repairedMtl(base::readInput(file));
    for (std::string& name : materialsOfMtl(*text)) materials_.insert(std::move(name));
  }
  if (!text) return nullptr;
  return &texts_.emplace(file.string(), std::move(*text)).first->second;
}

std::vector<std::string> MeshFileAccess::missingLibraries() const {
  std::vector<std::string> missing;
  for (const std::string& library : libraries_) {
    std::error_code ignored;
    if (!fs::is_regular_file(file_.parent_path() / withSlashes(library), ignored)) {
      missing.push_back(library);
    }
  }
  return missing;
}

void MeshFileAccess::checkPicture(const std::string& uri) {
  if (!root_ || refusal_ || uri.find("://") != std::string::npos) return;
  for (const std::string& spelling : {uri, percentDecoded(uri), withSlashes(percentDecoded(uri))}) {
    const fs::path picture = file_.parent_path() / spelling;
    if (isWithin(picture, *root_)) continue;
    refusal_ = "names the picture '" + uri + "', which is not below " + root_->string() +
               ", and is not read";
    return;
  }
}

}  // namespace synthetic_dataset::world
