#include "backends/vulkan/pipeline/vk_lavapipe_blocks.h"

#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <spirv_cross/spirv.hpp>

namespace vulkan {
namespace {

using Words = std::vector<uint32_t>;
constexpr size_t kHeaderWords = 5;
constexpr size_t kBound = 3;

struct Instruction {
  spv::Op op;
  std::span<const uint32_t> words;  ///< from the one with opcode and length
};

std::vector<Instruction> parsed(std::span<const uint32_t> spirv) {
  std::vector<Instruction> list;
  for (size_t at = kHeaderWords; at < spirv.size();) {
    const size_t length = spirv[at] >> 16;
    list.push_back({spv::Op(spirv[at] & 0xFFFF), spirv.subspan(at, length)});
    at += length;
  }
  return list;
}

void append(Words& to, spv::Op op, std::initializer_list<uint32_t> operands) {
  to.push_back(uint32_t(operands.size() + 1) << 16 | uint32_t(op));
  to.insert(to.end(), operands);
}
void append(Words& to, const Instruction& i) {
  to.insert(to.end(), i.words.begin(), i.words.end());
}

/// A value whose topmost bit is 0 in each invocation, inactive ones of a draw included.
struct Source {
  spv::BuiltIn builtIn;
  spv::Op scalar;       ///< OpTypeFloat or OpTypeInt
  uint32_t isSigned;    ///< of integers
  uint32_t components;  ///< 1: no vector
};

Source sourceOf(rhi::ShaderStage stage) {
  switch (stage) {
    case rhi::ShaderStage::Vertex:
      return {spv::BuiltInVertexIndex, spv::OpTypeInt, 1, 1};
    case rhi::ShaderStage::Geometry:
      return {spv::BuiltInPrimitiveId, spv::OpTypeInt, 1, 1};
    case rhi::ShaderStage::Fragment:
      return {spv::BuiltInFragCoord, spv::OpTypeFloat, 0, 4};
    case rhi::ShaderStage::Compute:
      break;
  }
  return {spv::BuiltInGlobalInvocationId, spv::OpTypeInt, 0, 3};
}

class Rewriter {
 public:
  Rewriter(std::span<const uint32_t> spirv, rhi::ShaderStage stage)
      : m_in(parsed(spirv)), m_source(sourceOf(stage)), m_nextId(spirv[kBound]) {
    m_out.assign(spirv.begin(), spirv.begin() + kHeaderWords);
    survey();
  }

  Words result() {
    if (m_blocks.empty()) return {};
    const bool isNew = !m_sourceVariable;
    if (isNew) m_sourceVariable = m_nextId++;
    append(m_out, spv::OpCapability, {spv::CapabilityUniformBufferArrayDynamicIndexing});
    bool beforeFunctions = true, beforeTypes = true;
    for (const Instruction& i : m_in) {
      if (i.op == spv::OpVariable && m_blocks.contains(i.words[2])) continue;  // declared anew
      if (isNew && beforeTypes && isType(i.op)) {
        beforeTypes = false;
        append(m_out, spv::OpDecorate,
               {*m_sourceVariable, spv::DecorationBuiltIn, uint32_t(m_source.builtIn)});
      }
      if (i.op == spv::OpFunction && beforeFunctions) {
        beforeFunctions = false;
        declare(isNew);
      }
      if (i.op == spv::OpEntryPoint && isNew) {
        m_out.push_back(uint32_t(i.words.size() + 1) << 16 | uint32_t(i.op));
        m_out.insert(m_out.end(), i.words.begin() + 1, i.words.end());
        m_out.push_back(*m_sourceVariable);
      } else if (isAccess(i)) {
        access(i);
      } else {
        append(m_out, i);
      }
    }
    m_out[kBound] = m_nextId;
    return std::move(m_out);
  }

 private:
  static bool isType(spv::Op op) { return op >= spv::OpTypeVoid && op <= spv::OpTypeFunction; }
  bool isAccess(const Instruction& i) const {
    return (i.op == spv::OpAccessChain || i.op == spv::OpInBoundsAccessChain) &&
           m_blocks.contains(i.words[3]);
  }

  void survey() {
    std::set<uint32_t> blockTypes;
    std::map<uint32_t, uint32_t> blockOfPointer;
    for (const Instruction& i : m_in) {
      const auto& w = i.words;
      if (i.op == spv::OpDecorate && w[2] == spv::DecorationBlock) blockTypes.insert(w[1]);
      if (i.op == spv::OpDecorate && w[2] == spv::DecorationBuiltIn && w[3] == m_source.builtIn)
        m_sourceVariable = w[1];
      if (i.op == spv::OpTypePointer && w[2] == spv::StorageClassUniform &&
          blockTypes.contains(w[3]))
        blockOfPointer[w[1]] = w[3];
      if (i.op == spv::OpVariable && blockOfPointer.contains(w[1]))
        m_blocks[w[2]] = blockOfPointer[w[1]];
      // Types of numbers and pointers must stand once.
      if (isType(i.op) || i.op == spv::OpTypePointer)
        m_types[{uint32_t(i.op), {w.begin() + 2, w.end()}}] = w[1];
    }
  }

  uint32_t type(spv::Op op, std::initializer_list<uint32_t> operands) {
    auto [it, isNew] = m_types.try_emplace({uint32_t(op), Words(operands)}, m_nextId);
    if (isNew) {
      m_out.push_back(uint32_t(operands.size() + 2) << 16 | uint32_t(op));
      m_out.push_back(m_nextId++);
      m_out.insert(m_out.end(), operands);
    }
    return it->second;
  }
  uint32_t constant(uint32_t value) {
    append(m_out, spv::OpConstant, {m_uint, m_nextId, value});
    return m_nextId++;
  }

  /// The blocks as arrays, and what the index needs, after all other declarations.
  void declare(bool sourceIsNew) {
    m_uint = type(spv::OpTypeInt, {32, 0});
    m_scalar = m_source.scalar == spv::OpTypeFloat ? type(spv::OpTypeFloat, {32})
                                                   : type(spv::OpTypeInt, {32, m_source.isSigned});
    m_vector = m_source.components > 1 ? type(spv::OpTypeVector, {m_scalar, m_source.components})
                                       : m_scalar;
    m_shift = constant(31);
    const uint32_t one = constant(1);
    if (sourceIsNew) {
      const uint32_t pointer = type(spv::OpTypePointer, {spv::StorageClassInput, m_vector});
      append(m_out, spv::OpVariable, {pointer, *m_sourceVariable, spv::StorageClassInput});
    }
    for (const auto& [variable, block] : m_blocks) {
      const uint32_t array = type(spv::OpTypeArray, {block, one});
      const uint32_t pointer = type(spv::OpTypePointer, {spv::StorageClassUniform, array});
      append(m_out, spv::OpVariable, {pointer, variable, spv::StorageClassUniform});
    }
  }

  void access(const Instruction& i) {
    uint32_t value = m_nextId++;
    append(m_out, spv::OpLoad, {m_vector, value, *m_sourceVariable});
    if (m_vector != m_scalar) {
      append(m_out, spv::OpCompositeExtract, {m_scalar, m_nextId, value, 0});
      value = m_nextId++;
    }
    if (m_scalar != m_uint) {
      append(m_out, spv::OpBitcast, {m_uint, m_nextId, value});
      value = m_nextId++;
    }
    append(m_out, spv::OpShiftRightLogical, {m_uint, m_nextId, value, m_shift});
    const uint32_t index = m_nextId++;
    m_out.push_back(uint32_t(i.words.size() + 1) << 16 | uint32_t(i.op));
    m_out.insert(m_out.end(), i.words.begin() + 1, i.words.begin() + 4);
    m_out.push_back(index);
    m_out.insert(m_out.end(), i.words.begin() + 4, i.words.end());
  }

  std::vector<Instruction> m_in;
  Source m_source;
  uint32_t m_nextId;
  Words m_out;
  std::map<uint32_t, uint32_t> m_blocks;  ///< variable -> its struct
  std::map<std::pair<uint32_t, Words>, uint32_t> m_types;
  std::optional<uint32_t> m_sourceVariable;
  uint32_t m_uint = 0, m_scalar = 0, m_vector = 0, m_shift = 0;
};

}  // namespace

std::vector<uint32_t> indexUniformBlocks(std::span<const uint32_t> spirv, rhi::ShaderStage stage) {
  Words rewritten = Rewriter(spirv, stage).result();
  return rewritten.empty() ? Words(spirv.begin(), spirv.end()) : rewritten;
}

}  // namespace vulkan
