// Which shaders a folder of sources yields. The rule, whole:
//   <folder>/<pass>.<stage>.glsl            -> shader "<folder>/<pass>.<stage>"
//   templates/<pass>.<stage>.glsl           -> once per technique T (a folder with
//   visibility.glsl),
//       if it includes <technique/...>         "T/<pass>.<stage>"; once per pair with transparency
//       and maybe <transparency/...>           X (a folder with emit.glsl): "T+X/<pass>.<stage>"
// Files without a stage are only included.
#pragma once

#include <filesystem>
#include <vector>

#include "backends/shader/compile.h"

namespace shader {

/// Jobs in a fixed order (sorted by name). Throws rhi::Error when `root` is no folder.
std::vector<CompileJob> collect(const std::filesystem::path& root);

/// Compiles everything below `root`; its files may also include files below `include`.
rhi::ShaderLibrary compileFolder(const std::filesystem::path& root,
                                 const std::filesystem::path& include = {});

}  // namespace shader
