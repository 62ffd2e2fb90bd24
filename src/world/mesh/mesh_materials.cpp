#include "world/mesh/mesh_materials.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <optional>

#include <assimp/material.h>
#include <assimp/scene.h>
#if __has_include(<assimp/GltfMaterial.h>)
#include <assimp/GltfMaterial.h>  // assimp 5.1 and newer
#else
#include <assimp/pbrmaterial.h>
#endif

#include "world/material/material_conversions.h"

namespace synthetic_dataset::world {
namespace {

float unit(float value) { return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 1.0F; }

std::optional<aiColor4D> colour(const aiMaterial& material, const char* key) {
  aiColor4D value;
  if (aiGetMaterialColor(&material, key, 0, 0, &value) != aiReturn_SUCCESS) return std::nullopt;
  return value;
}

/// The value of the first key that the material has: names differ between versions of assimp.
std::optional<float> number(const aiMaterial& material, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    float value = 0.0F;
    if (material.Get(key, 0, 0, value) == aiReturn_SUCCESS) return value;
  }
  return std::nullopt;
}

bool hasProperty(const aiMaterial& material, const char* key) {
  const aiMaterialProperty* property = nullptr;
  return aiGetMaterialProperty(&material, key, 0, 0, &property) == aiReturn_SUCCESS;
}

int shadingModel(const aiMaterial& material) {
  int model = 0;
  return material.Get(AI_MATKEY_SHADING_MODEL, model) == aiReturn_SUCCESS ? model : 0;
}

Eigen::Vector3f rgb(const aiColor4D& value) {
  return {unit(value.r), unit(value.g), unit(value.b)};
}

Eigen::Vector3f encoded(const Eigen::Vector3f& linear) {
  return linear.unaryExpr(&encodedComponent);
}

Eigen::Vector4f withAlpha(const Eigen::Vector3f& colour, float alpha) {
  return {colour.x(), colour.y(), colour.z(), alpha};
}

/// Whether an opacity picture is the same as the diffuse one: then its alpha is meant.
bool isSame(const TextureReference& a, const TextureReference& b) { return a.uri == b.uri; }

/// A transform (u, v) -> (scale u + offset, ...) starts from the picture's lower edge, and flipping
/// the coordinates only changes the sign of its offset (assimp, FlipUVsProcess); in Material, v
/// grows downwards.
void readTransform(const aiMaterial& from, Material& to) {
  aiUVTransform transform;
  if (from.Get(AI_MATKEY_UVTRANSFORM(aiTextureType_DIFFUSE, 0), transform) != aiReturn_SUCCESS) {
    return;
  }
  const aiVector2D& scale = transform.mScaling;
  const aiVector2D& shift = transform.mTranslation;
  if (!std::isfinite(scale.x + scale.y + shift.x + shift.y)) return;
  to.texture_scale = {scale.x, scale.y};
  to.texture_offset = {shift.x, 1.0F - scale.y + shift.y};
}

/// Reads Phong and Lambert materials: those of COLLADA, OBJ and all formats but glTF.
class ClassicReader {
 public:
  ClassicReader(const aiMaterial& from, std::string extension, MeshPictures& pictures)
      : from_(from), extension_(std::move(extension)), pictures_(pictures) {}

  MaterialSource read() {
    readColours();
    readShininess();
    readOpacity();
    readMaps();
    return std::move(result_);
  }

 private:
  bool isCollada() const { return extension_ == ".dae"; }
  Material& material() { return result_.material; }

  void readColours() {
    result_.texture = pictures_.find(from_, aiTextureType_DIFFUSE);
    const auto diffuse = colour(from_, "$clr.diffuse");
    if (diffuse) material().diffuse = withAlpha(rgb(*diffuse), 1.0F);
    // COLLADA has either a colour or a picture; assimp adds a grey to the picture.
    if (result_.texture && isCollada()) material().diffuse.setOnes();
    readAmbient();
    if (const auto specular = colour(from_, "$clr.specular")) material().specular = rgb(*specular);
    // The Lambert model has no highlight; assimp gives COLLADA's Lambert materials a grey one.
    if (isCollada() && shadingModel(from_) == aiShadingMode_Gouraud) material().specular.setZero();
    if (const auto emissive = colour(from_, "$clr.emissive")) material().emissive = rgb(*emissive);
  }

  /// If COLLADA gives no ambient colour, assimp uses one grey, and Gazebo Classic another
  /// (gazebo/common/Material.cc).
  void readAmbient() {
    constexpr float kAssimps = 0.1F;
    constexpr float kGazebos = 0.4F;
    const auto ambient = colour(from_, "$clr.ambient");
    if (!ambient) return;
    material().ambient = rgb(*ambient);
    const bool is_assimps = (material().ambient.array() == kAssimps).all();
    if (isCollada() && is_assimps) material().ambient.setConstant(kGazebos);
  }

  void readShininess() {
    const auto shininess = number(from_, {"$mat.shininess"});
    if (!shininess || !(*shininess > 0.0F)) return;  // the file gives none
    material().shininess = std::min(*shininess, 1e4F);
    material().roughness = roughnessOfShininess(*shininess);
  }

  void readOpacity() {
    const auto opacity = number(from_, {"$mat.opacity"});
    // Exporters disagree on which end of COLLADA's <transparency> is opaque, so 0 counts as opaque:
    // nobody models a thing that cannot be seen at all.
    if (opacity && unit(*opacity) > 0.0F) material().diffuse.w() = unit(*opacity);
    result_.opacity = pictures_.find(from_, aiTextureType_OPACITY);
    if (!result_.opacity) return;
    if (result_.texture && isSame(*result_.texture, *result_.opacity)) {
      result_.texture->alpha = AlphaMeaning::kOpacity;
      result_.opacity.reset();
      return;
    }
    result_.opacity->alpha = AlphaMeaning::kOpacity;
    result_.opacity->content = PictureContent::kAlphaFromGrey;
  }

  void readMaps() {
    for (const aiTextureType type : {aiTextureType_NORMALS, aiTextureType_HEIGHT}) {
      if (!result_.normal_map) result_.normal_map = pictures_.find(from_, type);
    }
    if (result_.normal_map) result_.normal_map->content = PictureContent::kNormalsOrHeights;
    result_.emissive_map = pictures_.find(from_, aiTextureType_EMISSIVE);
    if (result_.emissive_map && material().emissive.isZero()) material().emissive.setOnes();
    // As in Gazebo, the picture tints all light from the surface, including what it emits.
    if (!result_.emissive_map && !material().emissive.isZero()) {
      result_.emissive_map = result_.texture;
    }
    readTransform(from_, material());
  }

  const aiMaterial& from_;
  std::string extension_;
  MeshPictures& pictures_;
  MaterialSource result_;
};

std::string alphaMode(const aiMaterial& material) {
  aiString mode;
  if (material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) != aiReturn_SUCCESS) return "";
  return mode.C_Str();
}

/// Reads glTF materials (glTF 2.0, sections 3.9.2 to 3.9.5): numbers are factors on pictures,
/// colours are linear.
class GltfReader {
 public:
  GltfReader(const aiMaterial& from, MeshPictures& pictures) : from_(from), pictures_(pictures) {}

  MaterialSource read() {
    readColours();
    readAlpha();
    readMetallicRoughness();
    readMaps();
    readTransform(from_, material());
    return std::move(result_);
  }

 private:
  Material& material() { return result_.material; }

  void readColours() {
    result_.texture = pictures_.find(from_, aiTextureType_DIFFUSE);
    material().diffuse.setOnes();
    if (const auto diffuse = colour(from_, "$clr.diffuse")) {
      material().diffuse = withAlpha(encoded(rgb(*diffuse)), unit(diffuse->a));
    }
    material().ambient = material().diffuse.head<3>();  // for Classic; glTF has no ambient colour
    if (const auto emissive = colour(from_, "$clr.emissive")) {
      material().emissive = encoded(rgb(*emissive));
    }
    // KHR_materials_unlit
    material().lit = !hasProperty(from_, "$mat.gltf.unlit") && shadingModel(from_) != kUnlit;
  }

  void readAlpha() {
    const std::string mode = alphaMode(from_);
    const float alpha = material().diffuse.w();
    if (mode != "BLEND") material().diffuse.w() = 1.0F;
    material().texture_is_glass = mode == "BLEND";
    if (mode == "MASK") {
      const float cutoff = number(from_, {"$mat.gltf.alphaCutoff"}).value_or(0.5F);
      material().alpha_threshold = alpha > 0.0F ? cutoff / alpha : 2.0F;
    }
    if (result_.texture && (mode == "BLEND" || mode == "MASK")) {
      result_.texture->alpha = AlphaMeaning::kOpacity;
    }
  }

  void readMetallicRoughness() {
    // KHR_materials_pbrSpecularGlossiness has glossiness instead.
    const auto glossiness =
        number(from_, {"$mat.glossinessFactor", "$mat.gltf.pbrMetallicRoughness.glossinessFactor"});
    if (glossiness && hasProperty(from_, "$clr.specular")) {
      material().metalness = 0.0F;
      material().roughness = 1.0F - unit(*glossiness);
      return;
    }
    material().metalness =
        unit(number(from_, {"$mat.metallicFactor", "$mat.gltf.pbrMetallicRoughness.metallicFactor"})
                 .value_or(1.0F));
    material().roughness = unit(
        number(from_, {"$mat.roughnessFactor", "$mat.gltf.pbrMetallicRoughness.roughnessFactor"})
            .value_or(1.0F));
    result_.roughness_map = pictures_.find(from_, aiTextureType_UNKNOWN);
    result_.metalness_map = result_.roughness_map;
  }

  void readMaps() {
    result_.normal_map = pictures_.find(from_, aiTextureType_NORMALS);
    result_.emissive_map = pictures_.find(from_, aiTextureType_EMISSIVE);
  }

  static constexpr int kUnlit = aiShadingMode_NoShading;

  const aiMaterial& from_;
  MeshPictures& pictures_;
  MaterialSource result_;
};

}  // namespace

std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool isDefaultMaterial(const aiMaterial& material, const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  if (extension == ".stl" || extension == ".ply") return true;
  aiString name;
  const bool named = material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS;
  return named && std::string(name.C_Str()) == AI_DEFAULT_MATERIAL_NAME;
}

unsigned textureChannel(const aiMaterial& material) {
  aiString path;
  unsigned channel = 0;
  if (material.GetTexture(aiTextureType_DIFFUSE, 0, &path, nullptr, &channel) != aiReturn_SUCCESS) {
    return 0;
  }
  return channel;
}

MaterialSource readMaterial(const aiMaterial& material, const std::filesystem::path& file,
                            MeshPictures& pictures) {
  const std::string extension = extensionOf(file);
  MaterialSource result;
  if (extension == ".gltf" || extension == ".glb") {
    result = GltfReader(material, pictures).read();
  } else {
    result = ClassicReader(material, extension, pictures).read();
    if (isDefaultMaterial(material, file) && !result.texture) {
      result = MaterialSource{};
      result.material = defaultMaterial();
      result.is_default = true;
    }
  }
  int two_sided = 0;
  if (material.Get(AI_MATKEY_TWOSIDED, two_sided) == aiReturn_SUCCESS) {
    result.material.double_sided = two_sided != 0;
  }
  return result;
}

}  // namespace synthetic_dataset::world
