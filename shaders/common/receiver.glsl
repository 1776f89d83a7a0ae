// A receiver (decision D6): the point that asks for light, complete enough for every technique.
#define RECEIVER_SURFACE 0u
#define RECEIVER_MEDIUM 1u

struct Receiver {
  vec3 position;  // camera-relative
  vec3 normal;    // geometric, unit, toward the viewer; 0 in a medium
  vec3 dpdx;      // change of position to the next pixel, taken before any branch
  vec3 dpdy;
  uint instance;  // index; surfaces only
  uint mesh;      // persistent mesh key
  uint key;       // persistent surface key: mesh, instance and triangle
  uvec2 pixel;
  uint kind;
  uint concave;   // sides from which its surface rises before it: 1 the normal's, 2 the other
};

// What the surface there does with light: for techniques that replace directLight.
struct Reflector {
  vec3 albedo;
  float metallic;
  float roughness;
  float transmission;  // share of the diffuse part that passes
  vec3 normal;         // for shading, unit, on the viewer's side
  vec3 toEye;          // unit
};
