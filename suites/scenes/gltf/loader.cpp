#include "suites/scenes/edit/clean_names.h"
#include "suites/scenes/gltf/loader.h"

#include <new>

#include "base/text.h"
#include "suites/scenes/edit/framing.h"
#include "suites/scenes/gltf/check/check.h"
#include "suites/scenes/gltf/context.h"
#include "suites/scenes/gltf/source/compression.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

void complete(GltfContext& context) {
  Scene& scene = context.scene;
  if (context.degenerate > 0)
    context.warn(std::to_string(context.degenerate) + " triangles without area were dropped");
  if (context.repairedNormals > 0)
    context.warn(std::to_string(context.repairedNormals) +
                 " normals without length were replaced by those of triangles");
  if (scene.instances.empty()) context.warn("the file shows no triangles");
  if (scene.cameras.empty()) {
    scene.cameras.push_back(framingCamera(scene));
    context.warn(kCameraAdded);
  }
  if (scene.lights.empty()) {
    addDaylight(scene);
    context.warn(kLightAdded);
  }
  if (context.source.unsaid > 0)
    context.source.warnings.push_back("... and " + std::to_string(context.source.unsaid) +
                                      " more warnings");
  for (size_t i = 0; i < scene.lights.size(); ++i) scene.lights[i].key = uint32_t(i);
}

}  // namespace

Scene loadGltf(const std::filesystem::path& path, const GltfOptions& options) try {
  GltfSource source = readGltfSource(path, options);
  checkGltf(source);
  loadBuffers(source);
  unpackBufferViews(source);
  unpackPrimitives(source);
  const tinygltf::Model model = parseModel(source);
  Scene scene;
  scene.name = path.stem().string();
  scene.background = kNeutralBackground;
  GltfContext context{.source = source, .model = model, .scene = scene};
  readPoses(context);
  readImages(context);
  readMaterials(context);
  readMeshes(context);
  readNodes(context);
  playAnimation(context);
  complete(context);
  scene.warnings = std::move(source.warnings);
  cleanNames(scene);
  return scene;
} catch (const InputError&) {
  throw;
} catch (const std::bad_alloc&) {
  throw InputError(path.string(), "needs more memory than there is");
} catch (const std::exception& error) {
  // Nothing is known to get here; a file must never end the program all the same.
  throw InputError(path.string(), "cannot be read: " + base::shortened(base::printable(error.what()), 150));
}

}  // namespace sb
