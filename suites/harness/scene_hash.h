// Identity of a scene's content.
#pragma once

#include <string>

#include "techniques/scene/scene.h"

namespace sb {

/// 16 hex digits over everything that enters a picture: geometry, materials, texels, transforms,
/// lights, media, camera. Names and warnings do not enter.
std::string sceneHash(const Scene& scene);

}  // namespace sb
