// bench scene: what is in a scene and what it calls for; export as .glb.
#include <cstdio>

#include "suites/cli/commands.h"
#include "suites/scenes/analysis.h"
#include "suites/scenes/describe.h"
#include "suites/scenes/gltf_export.h"
#include "suites/scenes/procedural.h"

namespace sb {

int sceneCommand(const Options& options) {
  std::string spec = options.sceneName;
  for (const std::string& edit : options.selection.edits) spec = withEdit(spec, edit);
  const Scene scene = makeScene(spec);
  const Effects effects = analyse(scene, 1.0);
  if (!options.exportFile.empty()) exportGlb(scene, options.exportFile);
  if (options.sceneJson)
    std::printf("%s\n", describeJson(scene, effects).dump(2).c_str());
  else
    std::printf("%s", describeText(scene, effects).c_str());
  return 0;
}

}  // namespace sb
