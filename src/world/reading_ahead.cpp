#include "world/reading_ahead.h"

#include <filesystem>
#include <optional>
#include <utility>

namespace synthetic_dataset::world {

ReadingAhead::ReadingAhead(const std::vector<MentionedMesh>& meshes, const ResourceFinder& finder,
                           MeshLoader& known)
    : finder_(finder), loader_(finder_), known_(known) {
  std::vector<MeshAhead> files;
  for (const MentionedMesh& mesh : meshes) {
    const std::optional<std::filesystem::path> file = finder_.find(mesh.uri, mesh.folder);
    if (file && !known.knows(*file)) files.push_back({*file, mesh.shows_pictures});
  }
  // Later, where the system starts no more threads.
  reading_ = std::async(std::launch::async | std::launch::deferred,
                        [this, files] { loader_.readAhead(files); });
}

void ReadingAhead::finish() {
  reading_.get();
  known_.takeFrom(std::move(loader_));
}

}  // namespace synthetic_dataset::world
