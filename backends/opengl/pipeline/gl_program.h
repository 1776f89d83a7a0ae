// A linked program from the GLSL of its stages, with specialization constants set.
#pragma once

#include <span>
#include <string>

#include "backends/opengl/resources/gl_object.h"
#include "backends/rhi/desc.h"

namespace opengl {

/// Throws rhi::Error with the driver's log, or when a constant is declared by no stage.
UniqueName linkProgram(const Functions& gl, const std::string& label,
                       std::span<const rhi::ShaderCode* const> stages,
                       std::span<const rhi::SpecConstant> constants);

/// The shader's text with its constants defined behind the #version line: SPIRV-Cross writes each
/// as a macro with a default. Separate so that it can be tested.
std::string specialize(const rhi::ShaderCode& code, std::span<const rhi::SpecConstant> constants);

}  // namespace opengl
