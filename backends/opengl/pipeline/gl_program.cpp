#include "backends/opengl/pipeline/gl_program.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <vector>

#include "backends/opengl/device/gl_debug.h"
#include "backends/opengl/resources/gl_formats.h"
#include "backends/rhi/error.h"

namespace opengl {
namespace {

/// A literal that GLSL reads as exactly these bits, of exactly this type.
std::string literal(char type, uint32_t bits) {
  switch (type) {
    case 'b':
      return bits ? "true" : "false";
    case 'i': {
      const auto value = std::bit_cast<int32_t>(bits);
      // The literal of the least int would be a negated overflow.
      if (value == INT32_MIN) return "(-2147483647 - 1)";
      return "(" + std::to_string(value) + ")";
    }
    case 'f': {
      const auto value = std::bit_cast<float>(bits);
      if (!std::isfinite(value)) return "uintBitsToFloat(" + std::to_string(bits) + "u)";
      char text[48];
      std::snprintf(text, sizeof text, "(%.9g)", double(value));
      std::string number = text;
      if (number.find_first_of(".e") == std::string::npos) number.insert(number.size() - 1, ".0");
      return number;
    }
    default:
      return std::to_string(bits) + "u";
  }
}

const rhi::ShaderConstant* findConstant(const rhi::ShaderCode& code, uint32_t id) {
  auto it = std::ranges::find(code.constants, id, &rhi::ShaderConstant::id);
  return it == code.constants.end() ? nullptr : &*it;
}

std::string infoLog(const Functions& gl, GLuint name, bool program) {
  GLint length = 0;
  (program ? gl.GetProgramiv : gl.GetShaderiv)(name, GL_INFO_LOG_LENGTH, &length);
  std::string log(size_t(std::max(length, 1)), '\0');
  GLsizei written = 0;
  (program ? gl.GetProgramInfoLog : gl.GetShaderInfoLog)(name, GLsizei(log.size()), &written,
                                                         log.data());
  log.resize(size_t(written));
  return log;
}

UniqueName compileShader(const Functions& gl, const std::string& label, const rhi::ShaderCode& code,
                         std::span<const rhi::SpecConstant> constants) {
  const GLuint name = gl.CreateShader(shaderStage(code.stage));
  UniqueName shader(gl, name, [](const Functions& f, GLuint n) { f.DeleteShader(n); });
  const std::string source = specialize(code, constants);
  const char* text = source.c_str();
  gl.ShaderSource(name, 1, &text, nullptr);
  gl.CompileShader(name);
  GLint ok = GL_FALSE;
  gl.GetShaderiv(name, GL_COMPILE_STATUS, &ok);
  if (!ok)
    throw rhi::Error("glCompileShader", "GL_COMPILE_STATUS",
                     code.name + " of pipeline '" + label + "'\n" + infoLog(gl, name, false));
  return shader;
}

}  // namespace

std::string specialize(const rhi::ShaderCode& code, std::span<const rhi::SpecConstant> constants) {
  std::string defines;
  for (const rhi::SpecConstant& constant : constants)
    if (const rhi::ShaderConstant* declared = findConstant(code, constant.id))
      defines += "#define SPIRV_CROSS_CONSTANT_ID_" + std::to_string(constant.id) + " " +
                 literal(declared->type, constant.bits) + "\n";
  std::string text = code.glsl;
  const size_t version = text.find("#version");
  const size_t end = version == std::string::npos ? std::string::npos : text.find('\n', version);
  if (end == std::string::npos)
    throw rhi::Error("shader specialization", "", code.name + " has no #version line");
  text.insert(end + 1, defines);
  return text;
}

UniqueName linkProgram(const Functions& gl, const std::string& label,
                       std::span<const rhi::ShaderCode* const> stages,
                       std::span<const rhi::SpecConstant> constants) {
  for (const rhi::SpecConstant& constant : constants)
    if (std::ranges::none_of(stages, [&](const rhi::ShaderCode* code) {
          return findConstant(*code, constant.id) != nullptr;
        }))
      throw rhi::Error("createPipeline", "",
                       "pipeline '" + label + "' sets specialization constant " +
                           std::to_string(constant.id) + ", which no stage declares");
  const GLuint name = gl.CreateProgram();
  UniqueName program(gl, name, [](const Functions& f, GLuint n) { f.DeleteProgram(n); });
  std::vector<UniqueName> shaders;
  for (const rhi::ShaderCode* code : stages) {
    shaders.push_back(compileShader(gl, label, *code, constants));
    gl.AttachShader(name, shaders.back().get());
  }
  gl.LinkProgram(name);
  GLint ok = GL_FALSE;
  gl.GetProgramiv(name, GL_LINK_STATUS, &ok);
  if (!ok)
    throw rhi::Error("glLinkProgram", "GL_LINK_STATUS",
                     "pipeline '" + label + "'\n" + infoLog(gl, name, true));
  // Detached, the shaders' texts and intermediate code are freed with them.
  for (const UniqueName& shader : shaders) gl.DetachShader(name, shader.get());
  labelObject(gl, GL_PROGRAM, name, label);
  return program;
}

}  // namespace opengl
