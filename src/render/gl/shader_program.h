#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

#include "render/gl/gl_object.h"

namespace synthetic_dataset::render {

/// A vertex and a fragment shader, linked. Uniforms are set by their name in the source; setting
/// one that the compiler left out because nothing uses it does nothing.
class ShaderProgram {
 public:
  /// @throws Error with the compiler's message
  ShaderProgram(const GlFunctions& gl, const std::string& vertex_source,
                const std::string& fragment_source);

  void use() const;

  void set(const std::string& uniform, int value) const;
  void set(const std::string& uniform, std::uint32_t value) const;
  void set(const std::string& uniform, float value) const;
  void set(const std::string& uniform, const Eigen::Vector3f& value) const;
  void set(const std::string& uniform, const Eigen::Vector4f& value) const;
  void set(const std::string& uniform, const Eigen::Matrix4f& value) const;
  void set(const std::string& uniform, const std::vector<Eigen::Vector4f>& values) const;

 private:
  [[nodiscard]] GLint location(const std::string& uniform) const;

  const GlFunctions& gl_;
  GlProgram program_;
  mutable std::unordered_map<std::string, GLint> locations_;  // each queried once
};

/// Where the shaders' samplers find their textures.
enum TextureUnit : GLuint {
  kDiffuseUnit,
  kShadowUnit,
  kNormalUnit,
  kRoughnessUnit,
  kMetalnessUnit,
  kEmissiveUnit,
  kShadowSideUnit,
};

/// Assigns the units to a program's samplers; a sampler that the program lacks is ignored.
inline void setTextureUnits(const ShaderProgram& program) {
  program.set("diffuse_map", static_cast<int>(kDiffuseUnit));
  program.set("shadow_maps", static_cast<int>(kShadowUnit));
  program.set("shadow_sides", static_cast<int>(kShadowSideUnit));
  program.set("normal_map", static_cast<int>(kNormalUnit));
  program.set("roughness_map", static_cast<int>(kRoughnessUnit));
  program.set("metalness_map", static_cast<int>(kMetalnessUnit));
  program.set("emissive_map", static_cast<int>(kEmissiveUnit));
}

}  // namespace synthetic_dataset::render
