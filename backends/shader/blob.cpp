#include "backends/shader/blob.h"

#include <cstring>

#include "backends/rhi/error.h"

namespace shader {
namespace {

class Writer {
 public:
  void u32(uint32_t value) { bytes(&value, sizeof value); }
  void text(const std::string& s) {
    u32(uint32_t(s.size()));
    bytes(s.data(), s.size());
  }
  void bytes(const void* data, size_t size) { m_out.append(static_cast<const char*>(data), size); }
  std::string take() { return std::move(m_out); }

 private:
  std::string m_out;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> in) : m_in(in) {}
  uint32_t u32() {
    uint32_t value;
    bytes(&value, sizeof value);
    return value;
  }
  std::string text() {
    std::string s(u32(), '\0');
    bytes(s.data(), s.size());
    return s;
  }
  void bytes(void* out, size_t size) {
    if (size > m_in.size()) throw rhi::Error("embedded shaders", "", "the blob is cut short");
    std::memcpy(out, m_in.data(), size);
    m_in = m_in.subspan(size);
  }

 private:
  std::span<const std::byte> m_in;
};

}  // namespace

std::string toBlob(const rhi::ShaderLibrary& library) {
  Writer out;
  out.u32(uint32_t(library.size()));
  for (const auto& [name, code] : library) {
    out.text(name);
    out.u32(uint32_t(code.stage));
    out.u32(uint32_t(code.spirv.size()));
    out.bytes(code.spirv.data(), code.spirv.size() * 4);
    out.text(code.glsl);
    out.u32(uint32_t(code.resources.size()));
    for (const rhi::ShaderResource& r : code.resources) {
      out.u32(r.slot);
      out.u32(uint32_t(r.kind));
      out.u32(r.readOnly);
      out.text(r.name);
    }
    out.u32(uint32_t(code.constants.size()));
    for (const rhi::ShaderConstant& c : code.constants) {
      out.u32(c.id);
      out.u32(uint32_t(c.type));
      out.u32(c.defaultBits);
    }
  }
  return out.take();
}

void fromBlob(std::span<const std::byte> blob, rhi::ShaderLibrary& library) {
  Reader in(blob);
  for (uint32_t count = in.u32(); count > 0; --count) {
    rhi::ShaderCode code;
    code.name = in.text();
    code.stage = rhi::ShaderStage(in.u32());
    code.spirv.resize(in.u32());
    in.bytes(code.spirv.data(), code.spirv.size() * 4);
    code.glsl = in.text();
    code.resources.resize(in.u32());
    for (rhi::ShaderResource& r : code.resources) {
      r.slot = in.u32();
      r.kind = rhi::ShaderResourceKind(in.u32());
      r.readOnly = in.u32() != 0;
      r.name = in.text();
    }
    code.constants.resize(in.u32());
    for (rhi::ShaderConstant& c : code.constants) {
      c.id = in.u32();
      c.type = char(in.u32());
      c.defaultBits = in.u32();
    }
    library.add(std::move(code));
  }
}

}  // namespace shader
