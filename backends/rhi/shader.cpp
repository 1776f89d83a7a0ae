#include "backends/rhi/shader.h"

#include "backends/rhi/error.h"

namespace rhi {

const ShaderCode* ShaderLibrary::find(std::string_view name) const {
  auto it = m_codes.find(name);
  return it == m_codes.end() ? nullptr : &it->second;
}

const ShaderCode& ShaderLibrary::get(std::string_view name) const {
  if (const ShaderCode* code = find(name)) return *code;
  // The neighbour in sorted order shares the longest prefix: good enough a hint for a typing slip.
  auto it = m_codes.lower_bound(name);
  if (it == m_codes.end() && !m_codes.empty()) --it;
  throw Error("shader lookup", "",
              "no shader named '" + std::string(name) + "'" +
                  (m_codes.empty() ? "; the library is empty" : "; nearest: " + it->first));
}

}  // namespace rhi
