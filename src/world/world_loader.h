#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/stages.h"
#include "world/description.h"
#include "world/files/resource_finder.h"
#include "world/files/template_file.h"
#include "world/urdf/urdf_text.h"
#include "world/world_options.h"

namespace synthetic_dataset::world {

struct SdfFile;

/// Whether this is a model itself (XML) and not the URI of one.
[[nodiscard]] bool isModelText(const std::string& text);

/// Reads worlds and models, SDF and URDF. All that one loader has read shares its meshes and
/// pictures.
class WorldLoader {
 public:
  /// @param finder  has to outlive the loader
  /// @param on_stage  called when a step begins that may take long
  explicit WorldLoader(const ResourceFinder& finder, const LoadOptions& options = {},
                       base::OnStage on_stage = base::ignoreStage);
  explicit WorldLoader(ResourceFinder&&, const LoadOptions& = {},
                       base::OnStage = {}) = delete;  // it has to outlive this
  ~WorldLoader();
  WorldLoader(const WorldLoader&) = delete;
  WorldLoader& operator=(const WorldLoader&) = delete;

  /// Reads an SDF world, or a model file, SDF or URDF (or a light's), as a world with this one
  /// model. A xacro file is read as what xacro makes of it.
  /// @param uri  a path, or a URI that the finder can find; of a model's folder the file that its
  ///     model.config names
  /// @throws ErrorList with every fault of the file and of the files that it names ("world.sdf:
  ///     model 'shelf': link 'body': visual 'v': mesh 'model://x/y.dae': no such file; looked in
  ///     ...")
  [[nodiscard]] Description loadWorld(const std::string& uri);

  /// Reads one model from an SDF or a URDF file, or a folder with a model.config, or from the text
  /// of such a file, where only package://, model:// and absolute paths lead to others.
  /// @param name  the model's new name
  /// @param arguments  of a xacro file
  /// @throws ErrorList as loadWorld
  [[nodiscard]] Model loadModel(const std::string& model_or_uri, const std::string& name,
                                const TemplateArguments& arguments = {});

  /// What loadModel has left out or replaced so far; a world has its notes itself.
  [[nodiscard]] const std::vector<std::string>& modelNotes() const { return model_notes_; }

  /// The cameras of the models that loadModel has read, named by the models' new names.
  [[nodiscard]] const std::vector<CameraSensor>& modelCameras() const { return model_cameras_; }

  /// Their lidars, likewise.
  [[nodiscard]] const std::vector<LidarSensor>& modelLidars() const { return model_lidars_; }

 private:
  struct Caches;

  [[nodiscard]] Description loadFile(const std::string& uri, const TemplateArguments& arguments);
  [[nodiscard]] Description load(const SdfFile& file);
  [[nodiscard]] Description loadText(const std::string& text, const std::string& name);

  const ResourceFinder& finder_;
  LoadOptions options_;
  base::OnStage on_stage_;
  std::unique_ptr<Caches> caches_;
  std::vector<std::string> model_notes_;
  std::vector<CameraSensor> model_cameras_;
  std::vector<LidarSensor> model_lidars_;
};

/// WorldLoader::loadWorld of a loader for this once.
[[nodiscard]] Description loadWorld(const std::string& uri, const ResourceFinder& finder,
                                    const LoadOptions& options = {});

/// WorldLoader::loadModel of a loader for this once.
[[nodiscard]] Model loadModel(const std::string& uri, const std::string& name,
                              const ResourceFinder& finder);

}  // namespace synthetic_dataset::world
