#include "world/mesh/mesh_batch.h"

#include <cstddef>
#include <optional>
#include <utility>

#include "base/input_file.h"
#include "base/sandbox/sandboxed_batch.h"
#include "synthetic_dataset/errors.h"
#include "world/mesh/mesh_file_bytes.h"

namespace synthetic_dataset::world {

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
      continue;  // it is read by itself then
    }
  }
  return result;
}

}  // namespace synthetic_dataset::world
