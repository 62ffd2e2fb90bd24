#include "world/sdf/built_in_models.h"

#include <cctype>

namespace synthetic_dataset::world {
namespace {

constexpr const char* kGroundPlane = R"(<sdf version="1.6"><model name="ground_plane">
<static>true</static>
<link name="link">
  <collision name="collision">
    <geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry>
    <surface><friction><ode><mu>100</mu><mu2>50</mu2></ode></friction></surface>
  </collision>
  <visual name="visual">
    <cast_shadows>false</cast_shadows>
    <geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry>
    <material>
      <ambient>0.3 0.3 0.3 1</ambient>
      <diffuse>0.7 0.7 0.7 1</diffuse>
      <specular>0.01 0.01 0.01 1</specular>
    </material>
  </visual>
</link>
</model></sdf>)";

constexpr const char* kSun = R"(<sdf version="1.6"><light name="sun" type="directional">
<cast_shadows>true</cast_shadows>
<pose>0 0 10 0 0 0</pose>
<diffuse>0.8 0.8 0.8 1</diffuse>
<specular>0.2 0.2 0.2 1</specular>
<attenuation>
  <range>1000</range><constant>0.9</constant><linear>0.01</linear><quadratic>0.001</quadratic>
</attenuation>
<direction>-0.5 0.1 -0.9</direction>
</light></sdf>)";

}  // namespace

std::optional<std::string> builtInModel(const std::string& name) {
  std::string plain;
  for (const char c : name) {
    plain += c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  if (plain == "ground_plane") return kGroundPlane;
  if (plain == "sun") return kSun;
  return std::nullopt;
}

}  // namespace synthetic_dataset::world
