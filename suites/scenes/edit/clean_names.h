// Names and warnings of scene files made fit for terminals and reports, once, when a file is read.
#pragma once

#include "techniques/scene/scene.h"

namespace sb {

/// base::printable() for every name and warning of a scene.
void cleanNames(Scene& scene);

}  // namespace sb
