// A compiled shader as both APIs take it, and the library that names them.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "backends/rhi/types.h"

namespace rhi {

enum class ShaderResourceKind : uint8_t { UniformBuffer, StorageBuffer, Texture, Image };

/// A resource that a shader statically uses. `slot` is the flat number of types.h.
struct ShaderResource {
  uint32_t slot = 0;
  ShaderResourceKind kind = ShaderResourceKind::UniformBuffer;
  bool readOnly = true;  ///< false: the shader may write it (storage buffer or image)
  std::string name;
};

/// A specialization constant; `type` is 'b' bool, 'i' int, 'u' uint, 'f' float.
struct ShaderConstant {
  uint32_t id = 0;
  char type = 'u';
  uint32_t defaultBits = 0;
};

/// One stage, compiled. Vulkan takes `spirv`; OpenGL takes `glsl` (4.50 core, bindings already
/// remapped per type), in which constant n is the macro SPIRV_CROSS_CONSTANT_ID_n.
struct ShaderCode {
  std::string name;  ///< e.g. "cssm2/translucent.frag" or "cssm2+sorted/forward.frag"
  ShaderStage stage = ShaderStage::Vertex;
  std::vector<uint32_t> spirv;
  std::string glsl;
  std::vector<ShaderResource> resources;
  std::vector<ShaderConstant> constants;
};

/// All shaders by name. Addresses stay valid as long as the library lives; pipelines keep none.
class ShaderLibrary {
 public:
  void add(ShaderCode code) { auto name = code.name; m_codes[name] = std::move(code); }
  /// Throws Error that names the nearest existing shader when `name` is unknown.
  const ShaderCode& get(std::string_view name) const;
  const ShaderCode* find(std::string_view name) const;
  size_t size() const { return m_codes.size(); }
  auto begin() const { return m_codes.begin(); }
  auto end() const { return m_codes.end(); }

 private:
  std::map<std::string, ShaderCode, std::less<>> m_codes;
};

}  // namespace rhi
