#include "render/parts/shader_family.h"

#include <array>
#include <utility>

#include "render/gl/shader_program.h"

namespace synthetic_dataset::render {
namespace {

struct Macro {
  SurfaceFeatures feature;
  const char* name;
};

constexpr std::array<Macro, 12> kMacros = {{{feature::kTextured, "TEXTURED"},
                                            {feature::kHoles, "HOLES"},
                                            {feature::kGlass, "GLASS"},
                                            {feature::kTinted, "TINTED"},
                                            {feature::kUnlit, "UNLIT"},
                                            {feature::kNormalMap, "NORMAL_MAP"},
                                            {feature::kRoughnessMap, "ROUGHNESS_MAP"},
                                            {feature::kMetalnessMap, "METALNESS_MAP"},
                                            {feature::kEmissiveMap, "EMISSIVE_MAP"},
                                            {feature::kFog, "FOG"},
                                            {feature::kShadows, "SHADOWS"},
                                            {feature::kNearLimit, "NEAR_LIMIT"}}};

/// The source with the features' macros after its first line, which GLSL requires to be #version.
std::string withMacros(const std::string& source, SurfaceFeatures features, std::string macros) {
  const std::size_t first_line = source.find('\n') + 1;
  for (const Macro& macro : kMacros) {
    if ((features & macro.feature) != 0) macros += std::string("#define ") + macro.name + "\n";
  }
  return source.substr(0, first_line) + macros + source.substr(first_line);
}

}  // namespace

ShaderFamily::ShaderFamily(const GlFunctions& gl, std::string vertex_source,
                           std::string fragment_source, SurfaceFeatures understood,
                           std::string macros)
    : gl_(gl),
      vertex_source_(std::move(vertex_source)),
      fragment_source_(std::move(fragment_source)),
      understood_(understood),
      macros_(std::move(macros)) {}

const ShaderProgram& ShaderFamily::get(SurfaceFeatures features) {
  const SurfaceFeatures known = features & understood_;
  const auto found = programs_.find(known);
  if (found != programs_.end()) return found->second;
  const ShaderProgram& program =
      programs_
          .try_emplace(known, gl_, withMacros(vertex_source_, known, macros_),
                       withMacros(fragment_source_, known, macros_))
          .first->second;
  setTextureUnits(program);
  return program;
}

}  // namespace synthetic_dataset::render
