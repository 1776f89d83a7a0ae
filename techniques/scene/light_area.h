// Lights with an extent as a receiver sees them (spec 08, "Light disc"; spec 16, V-mode), one
// definition for the truth, its tracer and techniques: an ellipse or a parallelogram through the
// light's centre, over which visibility is averaged uniformly, whatever lies behind the receiver's
// horizon. A sphere of radius R at distance D is the disc perpendicular to the view that its
// tangent cone cuts out, of radius R D / sqrt(D^2 - R^2); an ellipsoid is the image of the unit
// sphere's disc under its half axes; a directional light is a disc at unit distance.
#pragma once

#include <array>
#include <cstdint>

#include "techniques/scene/scene.h"

namespace sb {

/// Does it have an extent: do its shadows have penumbrae?
bool isAreaLight(const Light& light);
/// Farthest that a point of a point or spot light lies from its centre, world units.
double lightRadius(const Light& light);
/// The same of what receivers see (LightPatch) of a light of that radius from `distance` away at
/// least: the disc of a round body is wider than the body, without bound near it. Infinite within.
double seenRadius(LightShape shape, double radius, double distance);
/// Is its shape an ellipsoid of equal axes along the world's?
bool isSphere(const Light& light);
/// Gives a point or spot light the shape of a sphere; 0: none.
void makeSphere(Light& light, double radius);

/// What a receiver sees of a light: points, or directions if the light is directional, relative to
/// the receiver.
struct LightPatch {
  glm::dvec3 centre = glm::dvec3(0);
  glm::dvec3 u = glm::dvec3(0), v = glm::dvec3(0);  ///< half axes; 0: a light without extent
  bool round = false;                               ///< an ellipse, else a parallelogram
  bool infinite = false;                            ///< directional: rays to it do not end
  bool inside = false;  ///< the receiver lies in the light: visibility is 1 and means nothing
  /// What the illumination from the light's centre at unit distance (directional: its own) is to be
  /// multiplied by to become radiance, times the patch's area: integrals over the patch are `power`
  /// times the mean of f cos / d^2. Flat shapes emit to both sides.
  double power = 0;

  /// A place on the patch, from its centre, in half axes: of onDisc() if round, else of onSquare().
  glm::dvec3 offset(const glm::dvec2& place) const { return place.x * u + place.y * v; }
  /// A convex polygon around it, relative to the receiver: eight corners if round, else its own
  /// four. Returns how many.
  size_t hull(std::array<glm::dvec3, 8>& corners) const;
};
/// `toCentre`: from the receiver to the light's position; ignored if the light is directional.
LightPatch lightPatch(const Light& light, const glm::dvec3& toCentre);

/// Take the unit square to [-1, 1]^2 and to the unit disc, uniformly (Shirley and Chiu's concentric
/// map).
glm::dvec2 onSquare(const glm::dvec2& square);
glm::dvec2 onDisc(const glm::dvec2& square);

/// Point `i` of the (0,2)-sequence in base 2 (van der Corput's and the second dimension of Sobol's;
/// spec 11, SEQ02) in units of 2^-32: every aligned run of 2^m points has one in each elementary
/// interval of area 2^-m.
glm::uvec2 sequencePoint(uint32_t i);
/// Of `count` points (a power of two) the i-th, in the middle of the intervals that it alone is in:
/// one point is the middle of the unit square.
glm::dvec2 netPoint(uint32_t i, uint32_t count);

}  // namespace sb
