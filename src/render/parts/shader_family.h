#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "render/gl/shader_program.h"

namespace synthetic_dataset::render {

/// What a surface requires of the shaders, as a set of bits. Each set has a program of its own, so
/// that a plain surface does not pay for the features of others.
using SurfaceFeatures = std::uint32_t;

namespace feature {
inline constexpr SurfaceFeatures kTextured = 1U << 0;  ///< a picture times the diffuse colour
inline constexpr SurfaceFeatures kHoles = 1U << 1;     ///< where the picture's alpha is small
inline constexpr SurfaceFeatures kGlass = 1U << 2;     ///< the picture's alpha is opacity
inline constexpr SurfaceFeatures kTinted = 1U << 3;    ///< vertices have colours
inline constexpr SurfaceFeatures kUnlit = 1U << 4;     ///< its own colour, regardless of lights
inline constexpr SurfaceFeatures kNormalMap = 1U << 5;
inline constexpr SurfaceFeatures kRoughnessMap = 1U << 6;
inline constexpr SurfaceFeatures kMetalnessMap = 1U << 7;
inline constexpr SurfaceFeatures kEmissiveMap = 1U << 8;
inline constexpr SurfaceFeatures kFog = 1U << 9;         ///< the world's, so all surfaces have it
inline constexpr SurfaceFeatures kShadows = 1U << 10;    ///< some light casts shadows
inline constexpr SurfaceFeatures kNearLimit = 1U << 11;  ///< the view has one
}  // namespace feature

/// Programs made from the same two sources, one for each set of features that is drawn: a feature
/// is a macro in the sources. A program is compiled when it is first requested.
class ShaderFamily {
 public:
  /// @param understood  the features that the sources know; others are ignored
  /// @param macros  lines that all programs have in addition to those of their features
  ShaderFamily(const GlFunctions& gl, std::string vertex_source, std::string fragment_source,
               SurfaceFeatures understood, std::string macros = "");

  /// The reference is valid as long as the family exists.
  [[nodiscard]] const ShaderProgram& get(SurfaceFeatures features);

 private:
  const GlFunctions& gl_;
  std::string vertex_source_;
  std::string fragment_source_;
  SurfaceFeatures understood_;
  std::string macros_;
  std::map<SurfaceFeatures, ShaderProgram> programs_;
};

}  // namespace synthetic_dataset::render
