// Changes to a scene that its spec carries behind '?', separated by ';', so that a cell's name and
// command say them:
//   Sponza.gltf?camera:eye=-8,5,0,at=4,4,0,fov=70;sun:direction=0.3,-1,0.2;fabric*:alpha=0.5,t=0.9,0.3,0.3
//   camera:eye=X,Y,Z,at=X,Y,Z[,fov=DEGREES]        looks from one world point at another
//   sun:direction=X,Y,Z[,lux=E]                    one white directional light instead of all lights
//   motion:[move=X,Y,Z][,turn=DEGREES][,steps=N]   the camera arrives at its place from X,Y,Z before
//                                                  it, turning about its up axis, in N frames [8];
//                                                  so many frames has what moves in the scene, too
//   motion:animation=NAME|INDEX[,...]              and an animation of a glTF file plays
//   camera:show=NAME|NUMBER                        the scene's camera of that name, or that one in the
//                                                  order of `bench scene`
//   ground:size=N                                  a plane below the scene, N times as wide (framing.h)
//   file:scene=NAME|INDEX[,outside=1]              which scene of a glTF file; files outside its folder
//   GLOB:alpha=A[,t=T or R,G,B]                    optics of the materials whose names match (D8)
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "suites/scenes/gltf/source/source.h"
#include "techniques/scene/scene.h"

namespace sb {

struct SceneEdit {
  std::string target;  ///< "camera", "sun", "motion", "ground", "file", or a glob over
                       ///< material names (* and ?)
  std::vector<std::pair<std::string, std::vector<double>>> values;  ///< in their documented order
  /// Values that are names, percent-encoded where a spec could not hold them.
  std::vector<std::pair<std::string, std::string>> names;

  /// Numbers of a key; null where it is not given.
  const std::vector<double>* find(std::string_view key) const;
  /// The first name, decoded.
  std::string name() const;
  /// For errors.
  std::string where() const;
};

/// What stands behind '?'. Throws InputError naming the edit and the value.
std::vector<SceneEdit> parseEdits(std::string_view text);
/// The same text for the same edits.
std::string canonicalEdits(const std::vector<SceneEdit>& edits);
/// Frames of a loop of what moves. Throws InputError when it is no whole number.
uint32_t motionSteps(const std::vector<SceneEdit>& edits);
/// Throws InputError when motion is asked for in a scene in which nothing moves.
void requireMotion(const Scene& scene, const std::vector<SceneEdit>& edits);
/// Throws InputError when a glob matches no material.
void applyEdits(Scene& scene, const std::vector<SceneEdit>& edits);

/// What the edits say about reading a file. Throws InputError when `isFile` is false and a scene or
/// an animation of a file is asked for.
GltfOptions fileOptions(const std::vector<SceneEdit>& edits, bool isFile);

}  // namespace sb
