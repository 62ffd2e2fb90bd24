#pragma once

#include <memory>
#include <string>
#include <vector>

#include "world/description.h"
#include "world/resource_finder.h"

namespace synthetic_dataset::world {

/// How cameras of the world see (values that SDF lacks).
struct SdfLoadOptions {
  double default_near = 0.05;   ///< [m]
  double default_far = 1000.0;  ///< [m]
};

/// Reads worlds and models. All that one loader has read shares its meshes and pictures.
class SdfLoader {
 public:
  /// @param finder  has to outlive the loader
  explicit SdfLoader(const ResourceFinder& finder, const SdfLoadOptions& options = {});
  ~SdfLoader();
  SdfLoader(const SdfLoader&) = delete;
  SdfLoader& operator=(const SdfLoader&) = delete;

  /// Reads an SDF world, or a model file (or a light's) as a world with this one model.
  /// @param uri  a path, or a URI that the finder can find; of a model's folder the file that its
  ///     model.config names
  /// @throws ErrorList with every fault of the file and of the files that it names ("world.sdf:
  ///     model 'shelf': link 'body': visual 'v': mesh 'model://x/y.dae': no such file; looked in
  ///     ...")
  [[nodiscard]] Description loadWorld(const std::string& uri);

  /// Reads one model from an SDF or a URDF file, or a folder with a model.config.
  /// @param name  the model's new name
  /// @throws ErrorList as loadWorld
  [[nodiscard]] Model loadModel(const std::string& uri, const std::string& name);

  /// What loadModel has left out or replaced so far; a world has its notes itself.
  [[nodiscard]] const std::vector<std::string>& modelNotes() const { return model_notes_; }

 private:
  struct Caches;

  const ResourceFinder& finder_;
  SdfLoadOptions options_;
  std::unique_ptr<Caches> caches_;
  std::vector<std::string> model_notes_;
};

/// SdfLoader::loadWorld of a loader for this once.
[[nodiscard]] Description loadWorld(const std::string& uri, const ResourceFinder& finder,
                                    const SdfLoadOptions& options = {});

/// SdfLoader::loadModel of a loader for this once.
[[nodiscard]] Model loadModel(const std::string& uri, const std::string& name,
                              const ResourceFinder& finder);

}  // namespace synthetic_dataset::world
