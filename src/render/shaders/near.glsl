// What a lens does not see since it is too near, though it lies beyond the near plane of this picture.
#ifdef NEAR_LIMIT
uniform vec4 near_limit;  // the axis along which it counts (zeros: by distance), and how far it reaches [m]
#endif

void discardTooNear() {
#ifdef NEAR_LIMIT
  float reach = near_limit.xyz == vec3(0.0) ? length(position_C) : dot(near_limit.xyz, position_C);
  if (reach < near_limit.w) discard;
#endif
}
