#include "world/mesh/mesh_pictures.h"

#include <utility>

#include <opencv2/imgcodecs.hpp>

#include <assimp/scene.h>

#include "world/mesh/collada_repair.h"

namespace synthetic_dataset::world {
namespace {

/// Raw pixels in the scene are encoded as a PNG file, as the other pictures are files already.
std::shared_ptr<const EmbeddedPicture> copyEmbedded(const aiTexture& texture,
                                                    const std::string& name) {
  auto picture = std::make_shared<EmbeddedPicture>();
  picture->name = name;
  if (texture.mHeight == 0) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(texture.pcData);
    picture->bytes.assign(bytes, bytes + texture.mWidth);
    return picture;
  }
  const cv::Mat pixels(static_cast<int>(texture.mHeight), static_cast<int>(texture.mWidth), CV_8UC4,
                       texture.pcData);  // aiTexel is blue, green, red, alpha
  cv::imencode(".png", pixels, picture->bytes);
  return picture;
}

}  // namespace

MeshPictures::MeshPictures(const aiScene& scene, std::filesystem::path file)
    : scene_(scene), file_(std::move(file)) {}

std::shared_ptr<const EmbeddedPicture> MeshPictures::embedded(const aiTexture& texture,
                                                              const std::string& name) {
  auto& picture = embedded_[&texture];
  if (!picture) picture = copyEmbedded(texture, file_.string() + name);
  return picture;
}

std::optional<TextureReference> MeshPictures::find(const aiMaterial& material, aiTextureType type) {
  aiString path;
  if (material.GetTexture(type, 0, &path) != aiReturn_SUCCESS) return std::nullopt;
  if (path.length == 0 || std::string(path.C_Str()) == kNoPicture) return std::nullopt;
  TextureReference reference;
  reference.uri = path.C_Str();
  reference.folder = file_.parent_path();
  if (const aiTexture* texture = scene_.GetEmbeddedTexture(path.C_Str())) {
    reference.embedded = embedded(*texture, reference.uri);
  }
  return reference;
}

}  // namespace synthetic_dataset::world
