// Where a surface is, from the depth that the camera sees at a pixel. After common/scene.glsl.
// Off by a step of the depth's float and by rounding of 4 x 2^-24 of the distance (spec 17, N4), and
// by what the rasteriser rounds of the depth that it interpolates.

// Along the camera's axis, in world units.
float distanceOfDepth(float depth) {
  vec4 d = frame.depthToDistance;
  return (d.x + d.y * depth) / (d.z + d.w * depth);
}

// Camera-relative. `window`: as gl_FragCoord.xy.
vec3 positionOfDepth(vec2 window, float depth) {
  vec3 ray = frame.rayOrigin.xyz + window.x * frame.rayRight.xyz + window.y * frame.rayUp.xyz;
  float distance = distanceOfDepth(depth);
  return frame.rayForward.w == 0.0 ? ray * distance : ray + frame.rayForward.xyz * distance;
}
