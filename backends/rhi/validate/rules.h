// Rules as data: a name and a function that looks at one thing asked of the device and writes what
// is wrong with it. The tables are in rules_pass.cpp, rules_draw.cpp, rules_binding.cpp and
// rules_resource.cpp.
#pragma once

#include <functional>
#include <span>

#include "backends/rhi/validate/state.h"

namespace rhi::validate {

struct Finding {
  std::string_view rule;
  std::string text;
};

using Emit = std::function<void(std::string)>;

template <class Check>
struct Rule {
  std::string_view name;
  void (*check)(const Check&, const Emit&);
};

struct PassCheck {
  const State& state;
  const ActivePass& pass;
};

/// A draw or a dispatch. Exactly one group of arguments is set.
struct DrawCheck {
  const State* state = nullptr;
  const ActivePass* pass = nullptr;
  PipelineId pipelineId;
  const PipelineInfo* pipeline = nullptr;
  std::span<const Binding> bindings;
  const DrawState* draw = nullptr;  ///< null: a dispatch
  const DrawArgs* direct = nullptr;
  const DrawIndexedArgs* indexed = nullptr;
  const IndirectArgs* indirect = nullptr;
  bool usesIndices = false;

  const Binding* at(uint32_t slot) const;  ///< the last binding of the slot, or null
  std::string where() const;               ///< "pass 'p', pipeline 'q'"
};

/// A range of a buffer, a region of a texture, or a copy between textures.
struct TransferCheck {
  const State& state;
  std::string_view call;
  BufferId buffer;
  uint64_t offset = 0, size = 0;
  TextureId texture;
  TextureRegion region;
  const TextureView* source = nullptr;
  const TextureView* target = nullptr;
  std::optional<BufferUse> needs;  ///< of the buffer
};

enum class QueryCall : uint8_t { Timestamp, Begin, End, EndOfPass };
struct QueryCheck {
  const State& state;
  QueryCall call = QueryCall::Timestamp;
  QueryPoolId pool;
  uint32_t index = 0;
};

std::span<const Rule<PassCheck>> passRules();
std::span<const Rule<DrawCheck>> drawRules();
std::span<const Rule<DrawCheck>> bindingRules();
std::span<const Rule<TransferCheck>> transferRules();
std::span<const Rule<QueryCheck>> queryRules();

template <class Check>
void runRules(std::span<const Rule<Check>> rules, const Check& check, std::vector<Finding>& out) {
  for (const Rule<Check>& rule : rules)
    rule.check(check, [&](std::string text) { out.push_back({rule.name, std::move(text)}); });
}

}  // namespace rhi::validate
