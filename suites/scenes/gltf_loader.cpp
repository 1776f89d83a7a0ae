#include "suites/scenes/gltf_loader.h"

#include <new>

#include "suites/scenes/framing.h"
#include "suites/scenes/gltf_check.h"
#include "suites/scenes/gltf_context.h"
#include "techniques/common/error.h"

namespace sb {
namespace {

void warnOfIgnored(GltfSource& source) {
  const nlohmann::json& json = source.json;
  if (json.contains("animations")) source.warn("animations are ignored");
  if (json.contains("skins")) source.warn("skins are ignored: meshes are shown in their bind pose");
  for (const auto& mesh : json.value("meshes", nlohmann::json::array()))
    for (const auto& primitive : mesh["primitives"])
      if (primitive.contains("targets"))
        source.warn("morph targets are ignored: meshes are shown without them");
}

void complete(GltfContext& context) {
  Scene& scene = context.scene;
  if (context.degenerate > 0)
    context.warn(std::to_string(context.degenerate) + " triangles without area were dropped");
  if (context.repairedNormals > 0)
    context.warn(std::to_string(context.repairedNormals) +
                 " normals without length were replaced by those of triangles");
  if (scene.instances.empty()) context.warn("the file shows no triangles");
  if (scene.cameras.empty()) {
    scene.cameras.push_back(framingCamera(sceneBox(scene)));
    context.warn(kCameraAdded);
  }
  if (scene.lights.empty()) {
    scene.lights.push_back(defaultLight());
    context.warn(kLightAdded);
  }
  for (size_t i = 0; i < scene.lights.size(); ++i) scene.lights[i].key = uint32_t(i);
}

}  // namespace

Scene loadGltf(const std::filesystem::path& path) try {
  GltfSource source = readGltfSource(path);
  checkGltf(source);
  loadBuffers(source);
  const tinygltf::Model model = parseModel(source);
  Scene scene;
  scene.name = path.stem().string();
  GltfContext context{source, model, scene};
  warnOfIgnored(source);
  readImages(context);
  readMaterials(context);
  readMeshes(context);
  readNodes(context);
  complete(context);
  scene.warnings = std::move(source.warnings);
  return scene;
} catch (const InputError&) {
  throw;
} catch (const std::bad_alloc&) {
  throw InputError(path.string(), "needs more memory than there is");
} catch (const std::exception& error) {
  // Nothing is known to get here; a file must never end the program all the same.
  throw InputError(path.string(), std::string("cannot be read: ") + error.what());
}

}  // namespace sb
