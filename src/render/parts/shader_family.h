#pragma once

#include <map>
#include <string>

#include "render/gl/shader_program.h"
#include "render/parts/surface_features.h"

namespace synthetic_dataset::render {

/// Programs made of the same two sources, one for each set of features that is drawn: a feature is
/// a macro in the sources. A program is compiled when it is first asked for.
class ShaderFamily {
 public:
  /// @param understood  the features that the sources know; others make no difference
  /// @param macros  lines that all programs have besides those of their features
  ShaderFamily(const GlFunctions& gl, std::string vertex_source, std::string fragment_source,
               SurfaceFeatures understood, std::string macros = "");

  /// The reference stays good as long as the family.
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
