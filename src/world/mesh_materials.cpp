#include "world/mesh_materials.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>

#include <opencv2/imgcodecs.hpp>

#include <assimp/material.h>
#include <assimp/scene.h>
#if __has_include(<assimp/GltfMaterial.h>)
#include <assimp/GltfMaterial.h>  // assimp 5.1 and newer
#else
#include <assimp/pbrmaterial.h>
#endif

#include "world/collada_repair.h"

namespace synthetic_dataset::world {
namespace {

std::optional<aiColor4D> colour(const aiMaterial& material, const char* key) {
  aiColor4D value;
  if (aiGetMaterialColor(&material, key, 0, 0, &value) != aiReturn_SUCCESS) return std::nullopt;
  return value;
}

float unit(float value) { return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 1.0F; }

Eigen::Vector3f rgb(const aiColor4D& value) {
  return {unit(value.r), unit(value.g), unit(value.b)};
}

std::string alphaMode(const aiMaterial& material) {
  aiString mode;
  if (material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) != aiReturn_SUCCESS) return "";
  return mode.C_Str();
}

/// A picture's alpha makes holes where the file says so: glTF's alphaMode, or an opacity picture
/// that is the diffuse one again (COLLADA's <transparent>, OBJ's map_d).
AlphaMeaning alphaMeaning(const aiMaterial& material, const aiString& diffuse) {
  const std::string mode = alphaMode(material);
  if (mode == "MASK" || mode == "BLEND") return AlphaMeaning::kOpacity;
  aiString opacity;
  const bool same = material.GetTexture(aiTextureType_OPACITY, 0, &opacity) == aiReturn_SUCCESS &&
                    opacity == diffuse;
  return same ? AlphaMeaning::kOpacity : AlphaMeaning::kIgnored;
}

/// Raw pixels within the scene are made a PNG file, as the others are.
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

std::optional<TextureReference> diffuseTexture(const aiScene& scene, const aiMaterial& material,
                                               const std::filesystem::path& file) {
  aiString path;
  if (material.GetTexture(aiTextureType_DIFFUSE, 0, &path) != aiReturn_SUCCESS) {
    return std::nullopt;
  }
  if (path.length == 0 || std::string(path.C_Str()) == kNoPicture) return std::nullopt;
  TextureReference reference;
  reference.uri = path.C_Str();
  reference.folder = file.parent_path();
  reference.alpha = alphaMeaning(material, path);
  if (const aiTexture* embedded = scene.GetEmbeddedTexture(path.C_Str())) {
    reference.embedded = copyEmbedded(*embedded, file.string() + reference.uri);
  }
  return reference;
}

float opacity(const aiMaterial& material) {
  float value = 1.0F;
  if (material.Get(AI_MATKEY_OPACITY, value) != aiReturn_SUCCESS) return 1.0F;
  // Exporters disagree on which end of COLLADA's <transparency> is opaque. Nobody models a thing
  // that cannot be seen at all.
  return unit(value) > 0.0F ? unit(value) : 1.0F;
}

/// Lambert's model has no highlight; assimp gives COLLADA's a grey one.
bool isMatte(const aiMaterial& material) {
  int model = 0;
  return material.Get(AI_MATKEY_SHADING_MODEL, model) == aiReturn_SUCCESS &&
         model == aiShadingMode_Gouraud;
}

/// glTF's two numbers; where a picture stands in their place they are factors of it, and mean
/// nothing alone.
void readMetallicRoughness([[maybe_unused]] const aiMaterial& from, [[maybe_unused]] Material& to) {
#ifdef AI_MATKEY_METALLIC_FACTOR  // assimp 5.1 and newer
  if (from.GetTextureCount(aiTextureType_UNKNOWN) > 0) return;
  float value = 0.0F;
  if (from.Get(AI_MATKEY_METALLIC_FACTOR, value) == aiReturn_SUCCESS) to.metalness = unit(value);
  if (from.Get(AI_MATKEY_ROUGHNESS_FACTOR, value) == aiReturn_SUCCESS) to.roughness = unit(value);
#endif
}

/// Formats without materials get one from assimp that no file has asked for.
bool isMadeUp(const aiMaterial& material, const std::filesystem::path& file) {
  if (extensionOf(file) == ".stl") return true;
  aiString name;
  const bool named = material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS;
  return named && std::string(name.C_Str()) == AI_DEFAULT_MATERIAL_NAME;
}

}  // namespace

std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

unsigned textureChannel(const aiMaterial& material) {
  aiString path;
  unsigned channel = 0;
  if (material.GetTexture(aiTextureType_DIFFUSE, 0, &path, nullptr, &channel) != aiReturn_SUCCESS) {
    return 0;
  }
  return channel;
}

MeshMaterial readMaterial(const aiScene& scene, const aiMaterial& material,
                          const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  MeshMaterial result;
  result.texture = diffuseTexture(scene, material, file);
  if (isMadeUp(material, file) && !result.texture) return result;
  const auto diffuse = colour(material, "$clr.diffuse");
  if (diffuse) result.material.diffuse << rgb(*diffuse), 1.0F;
  // COLLADA has either a colour or a picture; assimp adds a grey to the picture.
  if (result.texture && extension == ".dae") result.material.diffuse.setOnes();
  if (const auto specular = colour(material, "$clr.specular")) {
    result.material.specular = rgb(*specular);
  }
  if (isMatte(material) && extension == ".dae") result.material.specular.setZero();
  if (const auto emissive = colour(material, "$clr.emissive")) {
    result.material.emissive = rgb(*emissive);
  }
  result.material.diffuse.w() = opacity(material);
  if (alphaMode(material) == "BLEND" && diffuse) result.material.diffuse.w() = unit(diffuse->a);
  if (extension == ".gltf" || extension == ".glb") readMetallicRoughness(material, result.material);
  int two_sided = 0;
  if (material.Get(AI_MATKEY_TWOSIDED, two_sided) == aiReturn_SUCCESS) {
    result.material.double_sided = two_sided != 0;
  }
  return result;
}

}  // namespace synthetic_dataset::world
