// Where a receiver lies in a light's map, and how deep a lit surface may lie at other texels of the
// filter: the receiver's own plane, carried into light space (spec 01, receiver-plane bias). The
// plane comes from the geometric normal, not from screen derivatives: exact at edges and for both
// kinds of projection, since window depth is linear over the map on a plane. Depth is reversed: it
// falls with the distance from the light, and 0 is an empty texel.
layout(constant_id = 16) const uint kBias = 0u;     // BIAS_*
layout(constant_id = 17) const uint kKernel = 1u;   // odd width of the filter, texels
layout(constant_id = 18) const bool kTent = false;  // tent instead of box weights
// Some casters are concave: their maps hold receding depths (common/receding_depth.glsl).
layout(constant_id = 23) const bool kConcave = false;

#define BIAS_PLANE 0u
#define BIAS_SLOPE 1u
#define BIAS_NORMAL 2u
#define BIAS_CONSTANT 3u
// Steepest slope that is biased for: acne-free up to atan(10) = 84.3 degrees (spec 17, G11).
#define BIAS_TAN_MAX 10.0
// Of a constant bias, in texels at 45 degrees.
#define BIAS_CONSTANT_TEXELS 1.5
// Curved surfaces leave the receiver's plane within a wide filter: allowance for each texel that the
// filter reaches beyond its centre, in texels at 45 degrees. From the error against the truth on
// draped cloth (9x9: RMSE of visibility 0.38 without, 0.14 with; flat scenes are the same).
#define BIAS_CURVATURE_TEXELS 0.5

struct LightSample {
  bool inside;    // in the map's volume: else the receiver is lit
  vec3 uvz;       // map coordinates and depth, 0..1
  vec2 gradient;  // change of depth per unit of u and v along the receiver's plane
  float bias;     // added to the depth before a comparison: toward the light
  float texel;    // 1 / map size
  float layer;
  uint view;      // index into shadowViews
  float least;    // depth that is lit at any texel
};

// Face of a point light that looks at `d`: +x -x +y -y +z -z (techniques/scene/light_data.cpp).
uint cubeFace(vec3 d) {
  vec3 a = abs(d);
  if (a.x >= a.y && a.x >= a.z) return d.x >= 0.0 ? 0u : 1u;
  if (a.y >= a.z) return d.y >= 0.0 ? 2u : 3u;
  return d.z >= 0.0 ? 4u : 5u;
}

LightSample lightSample(uint light, Receiver r) {
  LightSample s;
  s.inside = false;
  LightData l = lightAt(light);
  if (l.ids.y == NO_SHADOW) return s;
  uint index = l.ids.y;
  if (l.ids.x == LIGHT_POINT) index += cubeFace(r.position - l.positionRange.xyz);
  s.view = index;
  ShadowViewData view = shadowViewAt(index);
  if (view.origin.w < 0.0) return s;

  precise vec3 p = r.position - view.origin.xyz;
  vec3 toLight = l.ids.x == LIGHT_DIRECTIONAL ? -l.directionScale.xyz : normalize(-p);
  float cosine = clamp(abs(dot(r.normal, toLight)), 1e-6, 1.0);
  float tangent = sqrt(1.0 - cosine * cosine) / cosine;
  float radius = 0.5 * float(kKernel + 1u);  // texels the filter reaches, bilinear taps included
  if (kBias == BIAS_NORMAL) {
    float texelWorld = view.texel.z * (view.texel.w > 0.0 ? abs(toClip(view.toClip, p).w) : 1.0);
    p += r.normal * (1.5 * radius * texelWorld * sqrt(1.0 - cosine * cosine));
  }
  vec4 clip = toClip(view.toClip, p);
  if (clip.w <= 0.0) return s;
  precise vec3 ndc = clip.xyz / clip.w;
  s.uvz = vec3(ndc.xy * 0.5 + 0.5, ndc.z);
  s.inside = all(greaterThanEqual(s.uvz, vec3(0))) && all(lessThanEqual(s.uvz, vec3(1)));

  vec4 plane = view.planeToClip * vec4(r.normal, -dot(r.normal, p));
  vec2 gradient = abs(plane.z) > 0.0 ? -2.0 * plane.xy / plane.z : vec2(0);
  if (tangent > BIAS_TAN_MAX) gradient *= BIAS_TAN_MAX / tangent;
  s.texel = view.texel.x;
  s.layer = view.origin.w;
  float slope = (abs(gradient.x) + abs(gradient.y)) * s.texel;
  // Rounding, in half-ulps: four of the depth itself and of the plane equation that a rasteriser
  // interpolates over the map, and 64 of the receiver's distance from the eye, which its position is
  // known relative to. Spec 17, N4 has four a component; but where clipping at the picture's edge
  // leaves a sliver of a triangle, software rasterisers interpolate over that (22 seen).
  float perLength = view.texel.w > 0.0
                        ? s.uvz.z / clip.w
                        : length(vec3(view.toClip[0].z, view.toClip[1].z, view.toClip[2].z));
  float rounding = 2.4e-7 * (s.uvz.z + abs(gradient.x) + abs(gradient.y) +
                             16.0 * perLength * length(r.position));
  // Quantisation of the map, and the 1/256-texel grid that rasterisers snap vertices to.
  s.bias = 2.0 * view.texel.y + rounding + slope * (1.0 / 64.0);
  s.gradient = vec2(0);
  float unit = tangent > 0.0 ? slope / tangent : 0.0;  // slope of a plane at 45 degrees
  // A surface that rises before its plane is stored receding, by as much as it may rise within the
  // filter, so that it does not come before the receiver itself; before the falling plane it might.
  bool rises = kConcave && view.ids.y != 0u &&
               (r.concave & (dot(r.normal, toLight) > 0.0 ? 1u : 2u)) != 0u;
  if (kBias == BIAS_PLANE) {
    s.gradient = gradient;
    if (!rises) s.bias += unit * float(kKernel / 2u) * BIAS_CURVATURE_TEXELS;
  }
  if (kBias == BIAS_SLOPE) s.bias += slope * radius;
  if (kBias == BIAS_CONSTANT) s.bias += unit * radius * BIAS_CONSTANT_TEXELS;
  s.least = rises ? s.uvz.z + s.bias : 0.0;
  return s;
}

float kernelWeight(int x, int y) {
  int h = int(kKernel) / 2;
  return kTent ? float((h + 1 - abs(x)) * (h + 1 - abs(y))) : 1.0;
}

// Depth that a lit receiver may have at the centre of a texel: it is lit where the map holds no more.
// At least 0, the depth of empty texels: beyond its own edge the receiver's plane may lie behind the
// far plane.
float tapDepth(LightSample s, ivec2 texel) {
  precise vec2 offset = (vec2(texel) + 0.5) * s.texel - s.uvz.xy;
  precise float depth = s.uvz.z + (s.gradient.x * offset.x + s.gradient.y * offset.y) + s.bias;
  return max(depth, s.least);
}

// N x N point comparisons against a depth map; outside the map is lit.
float filterDepth(sampler2DArray map, LightSample s) {
  int size = textureSize(map, 0).x;
  ivec2 centre = ivec2(floor(s.uvz.xy * float(size)));
  int h = int(kKernel) / 2;
  float lit = 0.0, total = 0.0;
  for (int y = -h; y <= h; ++y)
    for (int x = -h; x <= h; ++x) {
      ivec2 texel = centre + ivec2(x, y);
      bool outside = any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(size)));
      float w = kernelWeight(x, y);
      total += w;
      if (outside || tapDepth(s, texel) >= texelFetch(map, ivec3(texel, int(s.layer)), 0).r) lit += w;
    }
  return lit / total;
}
