// Mesh files of each format; the first byte selects the format. assimp reads them in a process of
// its own, and the result comes back as bytes; the first byte can also say that the input is those.
#include <array>

#include "fuzzing.h"
#include "world/mesh/mesh_file.h"
#include "world/mesh/mesh_file_bytes.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace synthetic_dataset;
  if (size == 0) return 0;
  constexpr std::array<const char*, 7> kExtensions = {".obj", ".stl",  ".dae", ".ply",
                                                      ".glb", ".gltf", ""};
  const std::string extension = kExtensions[(data[0] + 448U - '0') % kExtensions.size()];
  const std::string_view content = fuzzing::view(data + 1, size - 1);
  fuzzing::tolerating([&] {
    if (extension.empty()) {
      static_cast<void>(world::meshFileOf(content));
    } else {
      static_cast<void>(world::readMeshFile(fuzzing::write("input" + extension, content)));
    }
  });
  return 0;
}
