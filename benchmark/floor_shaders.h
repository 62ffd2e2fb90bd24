#pragma once

#include <string>

namespace synthetic_dataset::benchmark {

inline constexpr char kVertexShader[] = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 coordinates;
uniform mat4 world_from_mesh;
uniform mat4 clip_from_world;
uniform mat4 shadow_from_world;
out vec3 seen_normal;
out vec2 seen_coordinates;
out vec3 place_in_shadow;
void main() {
  place_in_shadow = (shadow_from_world * world_from_mesh * vec4(position, 1.0)).xyz;
  seen_normal = mat3(world_from_mesh) * normal;
  seen_coordinates = coordinates;
  gl_Position = clip_from_world * world_from_mesh * vec4(position, 1.0);
}
)";

/// @param shadows  the body of `passes`, the share of sunlight that is not in shadow
[[nodiscard]] inline std::string fragmentShader(const std::string& shadows) {
  return R"(#version 450 core
in vec3 seen_normal;
in vec2 seen_coordinates;
in vec3 place_in_shadow;
uniform vec4 diffuse;
uniform sampler2D picture;
uniform vec3 to_light;
uniform sampler2DShadow shadow;
uniform uint part;
layout(location = 0) out vec4 colour;
layout(location = 1) out uint identifier;
float passes() {
)" + shadows +
         R"(
}
void main() {
  float sun = max(dot(normalize(seen_normal), to_light), 0.0) * passes();
  colour = vec4(diffuse.rgb * texture(picture, seen_coordinates).rgb * (0.35 + 0.75 * sun), 1.0);
  identifier = part;
}
)";
}

inline constexpr char kNoShadows[] = "return 1.0;";
inline constexpr char kShadows[] = R"(
  vec3 place = vec3(0.5 * place_in_shadow.xy + 0.5, place_in_shadow.z + 0.002);
  float sum = 0.0;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      sum += texture(shadow, place + vec3((vec2(x, y) - 1.5) / textureSize(shadow, 0), 0.0));
    }
  }
  return sum / 16.0;
)";
inline constexpr char kDepthAlone[] = "#version 450 core\nvoid main() {}\n";

}  // namespace synthetic_dataset::benchmark
