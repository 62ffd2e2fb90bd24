#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include <assimp/material.h>

#include "world/material/texture_loader.h"

struct aiScene;
struct aiTexture;

namespace synthetic_dataset::world {

/// The pictures that the materials of one assimp scene refer to.
class MeshPictures {
 public:
  MeshPictures(const aiScene& scene, std::filesystem::path file);

  /// @return nothing if the material has no picture of this type
  [[nodiscard]] std::optional<TextureReference> find(const aiMaterial& material,
                                                     aiTextureType type);

 private:
  [[nodiscard]] std::shared_ptr<const EmbeddedPicture> embedded(const aiTexture& texture,
                                                                const std::string& name);

  const aiScene& scene_;
  std::filesystem::path file_;
  std::map<const aiTexture*, std::shared_ptr<const EmbeddedPicture>> embedded_;
};

}  // namespace synthetic_dataset::world
