// Changes to a scene that its spec carries behind '?', separated by ';', so that a cell's name and
// command say them:
//   Sponza.gltf?camera:eye=-8,5,0,at=4,4,0,fov=70;sun:direction=0.3,-1,0.2;fabric*:alpha=0.5,t=0.9,0.3,0.3
//   camera:eye=X,Y,Z,at=X,Y,Z[,fov=DEGREES]        looks from one world point at another
//   sun:direction=X,Y,Z[,lux=E]                    one white directional light instead of all lights
//   motion:move=X,Y,Z[,turn=DEGREES][,steps=N]     the camera arrives at its place from X,Y,Z before
//                                                  it, turning about its up axis, in N frames [8]
//   GLOB:alpha=A[,t=T or R,G,B]                    optics of the materials whose names match (D8)
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "techniques/common/scene.h"

namespace sb {

struct SceneEdit {
  std::string target;  ///< "camera", "sun", "motion", or a glob over material names (* and ?)
  std::vector<std::pair<std::string, std::vector<double>>> values;  ///< in their documented order
};

/// What stands behind '?'. Throws InputError naming the edit and the value.
std::vector<SceneEdit> parseEdits(std::string_view text);
/// The same text for the same edits.
std::string canonicalEdits(const std::vector<SceneEdit>& edits);
/// Throws InputError when a glob matches no material.
void applyEdits(Scene& scene, const std::vector<SceneEdit>& edits);

}  // namespace sb
