// GLSL 4.50 (Vulkan flavour) -> SPIR-V by glslang -> GLSL for OpenGL by SPIRV-Cross (facts.md,
// route A). Used by the build and by `--shaders DIR`.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "backends/rhi/shader.h"

namespace shader {

/// One compilation: a file below `root`, and what the include names in angle brackets stand for
/// ("technique" -> "cssm2": `#include <technique/visibility.glsl>` reads cssm2/visibility.glsl).
struct CompileJob {
  std::string name;  ///< of the result, e.g. "cssm2+sorted/forward.frag"
  std::filesystem::path root;
  std::filesystem::path file;  ///< relative to root
  rhi::ShaderStage stage = rhi::ShaderStage::Vertex;
  std::map<std::string, std::string> aliases;
  std::filesystem::path include =
      {};  ///< where includes that `root` lacks are sought; may be empty
};

/// Throws rhi::Error whose text carries glslang's "file:line: message" lines.
rhi::ShaderCode compile(const CompileJob& job);

/// Fills resources, constants and the OpenGL text from code.spirv. Internal to compile, separate so
/// that it can be tested.
void reflect(rhi::ShaderCode& code);

}  // namespace shader
