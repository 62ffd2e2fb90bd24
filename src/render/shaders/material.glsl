// The material of a surface at a fragment.

uniform vec4 diffuse;
uniform float roughness;
uniform float metalness;
uniform float alpha_threshold;
uniform sampler2D diffuse_map;
uniform sampler2D normal_map;
uniform sampler2D roughness_map;
uniform sampler2D metalness_map;
uniform sampler2D emissive_map;

in vec3 position_C;
in vec3 normal_C;
in vec2 coordinates;
#ifdef TINTED
in vec4 tint;
#endif

// The normal as perturbed by the normal map. The map's x axis is where the texture's u grows and
// its y axis where v decreases (v counts from the first row down): both from the derivatives of
// position and coordinates, so that meshes need no tangents (Schueler 2013, "Normal Mapping Without
// Precomputed Tangents").
vec3 bent(vec3 normal) {
  vec3 along_x = dFdx(position_C);
  vec3 along_y = dFdy(position_C);
  vec2 texture_x = dFdx(coordinates);
  vec2 texture_y = dFdy(coordinates);
  vec3 across_y = cross(along_y, normal);
  vec3 across_x = cross(normal, along_x);
  // Negative if the picture's axes are left-handed about the normal, which would flip both tangents.
  float turn = sign(dot(along_x, across_y));
  vec3 u_axis = turn * (across_y * texture_x.x + across_x * texture_y.x);
  vec3 v_axis = turn * (across_y * texture_x.y + across_x * texture_y.y);
  float longest = max(dot(u_axis, u_axis), dot(v_axis, v_axis));
  if (longest <= 0.0) return normal;  // no texture coordinates
  vec3 bend = texture(normal_map, coordinates).xyz * 2.0 - 1.0;
  return normalize((bend.x * u_axis - bend.y * v_axis) * inversesqrt(longest) + bend.z * normal);
}

// Everything except reflectance and emission, and the opacity.
Surface surfaceHere(out float opacity) {
  Surface surface;
  vec4 base = diffuse;
#ifdef TINTED
  base *= tint;
#endif
#ifdef TEXTURED
  vec4 texel = texture(diffuse_map, coordinates);
#ifdef HOLES
  if (texel.a < alpha_threshold) discard;  // as the other passes have it
#endif
  base.rgb *= texel.rgb;
#ifdef GLASS
  base.a *= texel.a;
#endif
#endif
  surface.base = base.rgb;
  opacity = base.a;
  surface.position_C = position_C;
  surface.face = normalize(normal_C);
  surface.normal = surface.face;
#ifdef NORMAL_MAP
  surface.normal = bent(surface.face);
#endif
  if (!gl_FrontFacing) {
    surface.face = -surface.face;
#ifndef CLASSIC  // which lights backs by the normals of their fronts
    surface.normal = -surface.normal;
#endif
  }
  surface.roughness = roughness;
#ifdef ROUGHNESS_MAP
  surface.roughness *= texture(roughness_map, coordinates).g;
#endif
  surface.metalness = metalness;
#ifdef METALNESS_MAP
  surface.metalness *= texture(metalness_map, coordinates).b;
#endif
  return surface;
}

// What the glow is multiplied by.
vec3 glowHere() {
#ifdef EMISSIVE_MAP
  return texture(emissive_map, coordinates).rgb;
#else
  return vec3(1.0);
#endif
}
