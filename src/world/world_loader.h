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

/// Whether a text is a model itself (XML) rather than the URI of one.
[[nodiscard]] bool isModelText(const std::string& text);

/// Reads worlds and models, SDF and URDF. Everything that one loader reads shares its meshes and
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

  /// Reads an SDF world; or a file of one model (SDF or URDF) or light, as a world with only that.
  /// Templates, such as xacro files, are expanded first.
  /// @param uri  a path, or a URI that the finder can find; for a model folder, the file that its
  ///     model.config names is read
  /// @throws ErrorList with every error in the file and in the files that it names ("world.sdf:
  ///     model 'shelf': link 'body': visual 'v': mesh 'model://x/y.dae': no such file; looked in
  ///     ...")
  [[nodiscard]] Description loadWorld(const std::string& uri);

  /// Reads one model from an SDF or a URDF file, or a folder with a model.config, or from the text
  /// of such a file, in which only package://, model:// and absolute paths can refer to other
  /// files.
  /// @param name  the model's new name
  /// @param arguments  for a xacro file
  /// @throws ErrorList as loadWorld
  [[nodiscard]] Model loadModel(const std::string& model_or_uri, const std::string& name,
                                const TemplateArguments& arguments = {});

  /// What loadModel has left out or replaced so far; the notes on a world are in its Description.
  [[nodiscard]] const std::vector<std::string>& modelNotes() const { return model_notes_; }

  /// The cameras of the models that loadModel has read, named by the models' new names.
  [[nodiscard]] const std::vector<CameraSensor>& modelCameras() const { return model_cameras_; }

  /// The lidars of those models, named in the same way.
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

/// WorldLoader::loadWorld with a temporary loader.
[[nodiscard]] Description loadWorld(const std::string& uri, const ResourceFinder& finder,
                                    const LoadOptions& options = {});

/// WorldLoader::loadModel with a temporary loader.
[[nodiscard]] Model loadModel(const std::string& uri, const std::string& name,
                              const ResourceFinder& finder);

}  // namespace synthetic_dataset::world
