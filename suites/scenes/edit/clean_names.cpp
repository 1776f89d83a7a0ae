#include "suites/scenes/edit/clean_names.h"

#include "base/text.h"

namespace sb {

void cleanNames(Scene& scene) {
  const auto clean = [](auto& list) {
    for (auto& item : list) item.name = base::printable(item.name);
  };
  scene.name = base::printable(scene.name);
  clean(scene.images);
  clean(scene.materials);
  clean(scene.meshes);
  clean(scene.instances);
  clean(scene.lights);
  clean(scene.media);
  clean(scene.cameras);
  for (std::string& warning : scene.warnings) warning = base::printable(warning);
}

}  // namespace sb
