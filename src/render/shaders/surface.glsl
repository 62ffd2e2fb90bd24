// A surface at a point that is seen.
struct Surface {
  vec3 position_C;
  vec3 face;    // its normal, towards the camera
  vec3 normal;  // as a normal map bends it
  vec3 base;    // linear colour
  float reflectance;
  float roughness;
  float metalness;
  vec3 glow;
};
