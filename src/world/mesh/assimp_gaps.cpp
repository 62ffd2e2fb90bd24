#include "world/mesh/assimp_gaps.h"

#include <string>

#include <assimp/version.h>

#include "base/input_file.h"
#include "world/mesh/mesh_materials.h"

namespace synthetic_dataset::world {
namespace {

std::string thisAssimp() {
  return "assimp " + std::to_string(aiGetVersionMajor()) + "." +
         std::to_string(aiGetVersionMinor()) + " of this system";
}

bool removeColours(MeshFile& content) {
  bool has_any = false;
  for (MeshPart& part : content.parts) {
    has_any = has_any || !part.mesh.colours.empty();
    part.mesh.colours.clear();
  }
  return has_any;
}

}  // namespace

bool assimpHasGaps() {
  const unsigned major = aiGetVersionMajor();
  return major < 5 || (major == 5 && aiGetVersionMinor() < 1);
}

void removeUnreliableData(const std::filesystem::path& file, MeshFile& content) {
  if (!assimpHasGaps()) return;
  const std::string extension = extensionOf(file);
  if (extension == ".stl" && removeColours(content)) {
    content.notes.push_back("its colours are left out, as " + thisAssimp() + " reads them wrong");
  }
  const bool is_gltf = extension == ".gltf" || extension == ".glb";
  if (is_gltf && base::readInput(file).find("KHR_texture_transform") != std::string::npos) {
    content.notes.push_back("its textures are not moved or scaled (KHR_texture_transform), as " +
                            thisAssimp() + " does not read that");
  }
}

}  // namespace synthetic_dataset::world
