// Which shaders a folder of sources yields. The rule, whole:
//   <folder>/<pass>.<stage>.glsl            -> shader "<folder>/<pass>.<stage>"
//   templates/<pass>.<stage>.glsl           -> "T[+X][@L]/<pass>.<stage>", once for each technique T
//       that includes <technique/...>,         (a folder with visibility.glsl), transparency X (with
//       <transparency/...>, <lights/...>       emit.glsl) and loop of lights L (with lights.glsl)
//                                              that it asks for; L = all_lights is left out
// Files without a stage are only included. Templates and partners are sought in the folder that may be
// included, too: a folder with one technique yields its pairs with all transparencies.
#pragma once

#include <filesystem>
#include <vector>

#include "backends/shader/compile.h"

namespace shader {

/// Jobs in a fixed order (sorted by name): whatever something below `root` takes part in. Throws
/// rhi::Error when `root` is no folder.
std::vector<CompileJob> collect(const std::filesystem::path& root,
                                const std::filesystem::path& include = {});

/// Compiles everything below `root`; its files may also include files below `include`.
rhi::ShaderLibrary compileFolder(const std::filesystem::path& root,
                                 const std::filesystem::path& include = {});

}  // namespace shader
