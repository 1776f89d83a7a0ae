// bench scene: what is in a scene and what it calls for; export as .glb.
#include "suites/cli/commands/commands.h"
#include "suites/cli/say.h"
#include "suites/scenes/analysis/analysis.h"
#include "suites/scenes/analysis/describe.h"
#include "suites/scenes/gltf/write/export.h"
#include "suites/scenes/procedural/procedural.h"

namespace sb {

int sceneCommand(const Options& options) {
  std::string spec = options.scene.name;
  for (const std::string& edit : options.selection.edits) spec = withEdit(spec, edit);
  const Scene scene = makeScene(spec);
  const Effects effects = analyse(scene, 1.0);
  if (!options.scene.exportFile.empty()) {
    exportGlb(scene, options.scene.exportFile);
    if (!scene.path.empty())
      say("warning: " + options.scene.exportFile +
          " holds the scene where its motion ends: a path is not exported");
  }
  if (options.scene.json)
    print(describeJson(scene, effects).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
          "\n");
  else
    print(describeText(scene, effects));
  return 0;
}

}  // namespace sb
