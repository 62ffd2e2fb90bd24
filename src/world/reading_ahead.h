#pragma once

#include <future>
#include <vector>

#include "world/files/resource_finder.h"
#include "world/mesh/mesh_loader.h"
#include "world/sdf/mentioned_meshes.h"

namespace synthetic_dataset::world {

/// Reads meshes and their pictures in the background, while libsdformat reads the files that name
/// them, which takes longer.
class ReadingAhead {
 public:
  /// @param known  whose files are not read again; gets what is read
  ReadingAhead(const std::vector<MentionedMesh>& meshes, const ResourceFinder& finder,
               MeshLoader& known);

  /// Waits, and hands over; to be called once. What could not be read is reported when it is asked
  /// for.
  void finish();

 private:
  ResourceFinder finder_;  ///< for one thread, and of what may not be wanted after all
  MeshLoader loader_;
  MeshLoader& known_;
  std::future<void> reading_;  ///< ended first
};

}  // namespace synthetic_dataset::world
