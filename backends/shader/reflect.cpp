// What a SPIR-V module uses, and its OpenGL text (SPIRV-Cross, C interface).
#include <spirv_cross/spirv_cross_c.h>

#include <algorithm>
#include <memory>
#include <span>

#include "backends/rhi/error.h"
#include "backends/shader/compile.h"

namespace shader {
namespace {

using rhi::ShaderResourceKind;

struct ContextDeleter {
  void operator()(spvc_context context) const { spvc_context_destroy(context); }
};
using Context = std::unique_ptr<spvc_context_s, ContextDeleter>;

void check(spvc_context context, spvc_result result, const rhi::ShaderCode& code, const char* call) {
  if (result != SPVC_SUCCESS)
    throw rhi::Error(call, "", code.name + ": " + spvc_context_get_last_error_string(context));
}

struct KindRange {
  spvc_resource_type type;
  ShaderResourceKind kind;
  uint32_t base;
  uint32_t end;
};
constexpr KindRange kRanges[] = {
    {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, ShaderResourceKind::UniformBuffer, rhi::kUniformSlotBase,
     rhi::kStorageSlotBase},
    {SPVC_RESOURCE_TYPE_STORAGE_BUFFER, ShaderResourceKind::StorageBuffer, rhi::kStorageSlotBase,
     rhi::kTextureSlotBase},
    {SPVC_RESOURCE_TYPE_SAMPLED_IMAGE, ShaderResourceKind::Texture, rhi::kTextureSlotBase,
     rhi::kImageSlotBase},
    {SPVC_RESOURCE_TYPE_STORAGE_IMAGE, ShaderResourceKind::Image, rhi::kImageSlotBase,
     rhi::kSlotCount},
};

bool isReadOnly(spvc_compiler compiler, const spvc_reflected_resource& resource,
                ShaderResourceKind kind) {
  if (kind == ShaderResourceKind::UniformBuffer || kind == ShaderResourceKind::Texture) return true;
  if (kind == ShaderResourceKind::Image)
    return spvc_compiler_has_decoration(compiler, resource.id, SpvDecorationNonWritable);
  const SpvDecoration* decorations = nullptr;
  size_t count = 0;
  spvc_compiler_get_buffer_block_decorations(compiler, resource.id, &decorations, &count);
  return std::find(decorations, decorations + count, SpvDecorationNonWritable) !=
         decorations + count;
}

/// Lists what the shader uses, and gives every binding (blocks that it does not use are still in the
/// text, and must agree between stages) its OpenGL number.
void collectResources(spvc_context context, spvc_compiler compiler, rhi::ShaderCode& code) {
  spvc_set active = nullptr;
  spvc_resources used = nullptr, all = nullptr;
  check(context, spvc_compiler_get_active_interface_variables(compiler, &active), code, "spvc");
  check(context,
        spvc_compiler_create_shader_resources_for_active_variables(compiler, &used, active), code,
        "spvc");
  check(context, spvc_compiler_create_shader_resources(compiler, &all), code, "spvc");
  auto listOf = [&](spvc_resources resources, spvc_resource_type type) {
    const spvc_reflected_resource* list = nullptr;
    size_t count = 0;
    check(context, spvc_resources_get_resource_list_for_type(resources, type, &list, &count), code,
          "spvc");
    return std::span(list, count);
  };
  for (const KindRange& range : kRanges) {
    for (const spvc_reflected_resource& resource : listOf(used, range.type))
      code.resources.push_back(
          {.slot = spvc_compiler_get_decoration(compiler, resource.id, SpvDecorationBinding),
           .kind = range.kind,
           .readOnly = isReadOnly(compiler, resource, range.kind),
           .name = resource.name});
    for (const spvc_reflected_resource& resource : listOf(all, range.type)) {
      const uint32_t slot =
          spvc_compiler_get_decoration(compiler, resource.id, SpvDecorationBinding);
      if (slot < range.base || slot >= range.end)
        throw rhi::Error("shader reflection", "",
                         code.name + ": '" + resource.name + "' is at binding " +
                             std::to_string(slot) + ", its kind belongs to " +
                             std::to_string(range.base) + ".." + std::to_string(range.end - 1));
      spvc_compiler_set_decoration(compiler, resource.id, SpvDecorationBinding, slot - range.base);
    }
  }
  std::ranges::sort(code.resources, {}, &rhi::ShaderResource::slot);
}

void collectConstants(spvc_context context, spvc_compiler compiler, rhi::ShaderCode& code) {
  const spvc_specialization_constant* list = nullptr;
  size_t count = 0;
  check(context, spvc_compiler_get_specialization_constants(compiler, &list, &count), code, "spvc");
  for (size_t i = 0; i < count; ++i) {
    spvc_constant constant = spvc_compiler_get_constant_handle(compiler, list[i].id);
    spvc_type type =
        spvc_compiler_get_type_handle(compiler, spvc_constant_get_type(constant));
    char letter = 'u';
    switch (spvc_type_get_basetype(type)) {
      case SPVC_BASETYPE_BOOLEAN: letter = 'b'; break;
      case SPVC_BASETYPE_INT32: letter = 'i'; break;
      case SPVC_BASETYPE_FP32: letter = 'f'; break;
      default: break;
    }
    code.constants.push_back({.id = list[i].constant_id,
                              .type = letter,
                              .defaultBits = spvc_constant_get_scalar_u32(constant, 0, 0)});
  }
  std::ranges::sort(code.constants, {}, &rhi::ShaderConstant::id);
}

}  // namespace

void reflect(rhi::ShaderCode& code) {
  spvc_context raw = nullptr;
  if (spvc_context_create(&raw) != SPVC_SUCCESS)
    throw rhi::Error("spvc_context_create", "", code.name);
  Context context(raw);
  spvc_parsed_ir ir = nullptr;
  check(raw, spvc_context_parse_spirv(raw, code.spirv.data(), code.spirv.size(), &ir), code,
        "spvc_context_parse_spirv");
  spvc_compiler compiler = nullptr;
  check(raw,
        spvc_context_create_compiler(raw, SPVC_BACKEND_GLSL, ir, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP,
                                     &compiler),
        code, "spvc_context_create_compiler");
  collectResources(raw, compiler, code);
  collectConstants(raw, compiler, code);

  spvc_compiler_options options = nullptr;
  check(raw, spvc_compiler_create_compiler_options(compiler, &options), code, "spvc options");
  spvc_compiler_options_set_uint(options, SPVC_COMPILER_OPTION_GLSL_VERSION, 450);
  spvc_compiler_options_set_bool(options, SPVC_COMPILER_OPTION_GLSL_ES, SPVC_FALSE);
  spvc_compiler_install_compiler_options(compiler, options);
  // A vertex shader that picks the layer needs this extension named (facts.md). Which built-ins are
  // active is not known before it is asked for.
  spvc_compiler_update_active_builtins(compiler);
  if (code.stage == rhi::ShaderStage::Vertex &&
      spvc_compiler_has_active_builtin(compiler, SpvBuiltInLayer, SpvStorageClassOutput))
    spvc_compiler_require_extension(compiler, "GL_ARB_shader_viewport_layer_array");
  const char* text = nullptr;
  check(raw, spvc_compiler_compile(compiler, &text), code, "spvc_compiler_compile");
  code.glsl = text;
}

}  // namespace shader
