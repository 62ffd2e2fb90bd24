#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "plugins/readback/kept_files.h"
#include "synthetic_dataset/scene.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::formats {

/// What a writer made of one scene.
struct WrittenScene {
  std::filesystem::path folder;              ///< the writer's, absolute
  std::string name;                          ///< Scene::name: "00000012", "front/00000012"
  std::size_t camera_index = 0;              ///< Scene::camera_index
  Stamp stamp{0};                            ///< Scene::stamp
  std::vector<std::filesystem::path> files;  ///< of this scene, absolute, in alphabetical order

  /// Shared by consecutively read scenes of a dataset.
  std::shared_ptr<KeptFiles> kept = std::make_shared<KeptFiles>();

  Value::Map settings = {};  ///< the writer's accepted settings

  /// The file whose path relative to `folder` ends in `end`; the first if there are several.
  /// @throws Error if there is none
  [[nodiscard]] std::filesystem::path file(const std::string& end) const;
};

}  // namespace synthetic_dataset::formats
