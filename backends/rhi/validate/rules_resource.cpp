// Rules about transfers and queries.
#include <algorithm>

#include "backends/rhi/validate/rules.h"

namespace rhi::validate {
namespace {

void transferRange(const TransferCheck& c, const Emit& emit) {
  if (c.texture || c.source) return;
  const BufferInfo* buffer = c.state.find(c.buffer);
  if (!buffer)
    emit(std::string(c.call) + ": the buffer does not exist");
  else if (c.size > buffer->desc.size || c.offset > buffer->desc.size - c.size)
    emit(std::string(c.call) + ": bytes " + std::to_string(c.offset) + " to " +
         std::to_string(c.offset + c.size) + " are outside buffer '" + buffer->desc.label + "'");
}

void transferFlag(const TransferCheck& c, const Emit& emit) {
  if (const BufferInfo* buffer = c.state.find(c.buffer); buffer && c.needs)
    if (!has(buffer->desc.use, *c.needs))
      emit(std::string(c.call) + ": buffer '" + buffer->desc.label + "' lacks BufferUse::" +
           (*c.needs == BufferUse::CopySource ? "CopySource" : "CopyTarget"));
  auto check = [&](const TextureView* view, TextureUse needs, const char* name) {
    const TextureInfo* texture = view ? c.state.find(view->texture) : nullptr;
    if (texture && !has(texture->desc.use, needs))
      emit(std::string(c.call) + ": texture '" + texture->desc.label +
           "' lacks TextureUse::" + name);
  };
  check(c.source, TextureUse::CopySource, "CopySource");
  check(c.target, TextureUse::CopyTarget, "CopyTarget");
}

void regionBounds(const TransferCheck& c, const Emit& emit) {
  if (!c.texture) return;
  const TextureInfo* texture = c.state.find(c.texture);
  if (!texture) {
    emit(std::string(c.call) + ": the texture does not exist");
    return;
  }
  const TextureDesc& d = texture->desc;
  const TextureRegion& r = c.region;
  const uint32_t mip = std::min(r.mip, 31u);
  const uint32_t width = std::max(1u, d.width >> mip), height = std::max(1u, d.height >> mip);
  const uint32_t layers = d.kind == TextureKind::Tex3D ? std::max(1u, d.depth >> mip) : d.layers;
  auto inside = [](uint32_t at, uint32_t size, uint32_t all) {
    return at < all && (size == kAllRemaining || (size > 0 && size <= all - at));
  };
  if (r.mip >= d.mips || r.layer >= layers || !inside(r.x, r.width, width) ||
      !inside(r.y, r.height, height))
    emit(std::string(c.call) + ": the region (mip " + std::to_string(r.mip) + ", layer " +
         std::to_string(r.layer) + ", at " + std::to_string(r.x) + "," + std::to_string(r.y) +
         ") is outside texture '" + d.label + "'");
  if (d.samples > 1)
    emit(std::string(c.call) + ": texture '" + d.label + "' is multisampled; resolve it first");
}

void copyMatch(const TransferCheck& c, const Emit& emit) {
  if (!c.source || !c.target) return;
  const TextureInfo* from = c.state.find(c.source->texture);
  const TextureInfo* to = c.state.find(c.target->texture);
  if (!from || !to) {
    emit(std::string(c.call) + ": a texture of the copy does not exist");
    return;
  }
  const Range a = from->range(*c.source), b = to->range(*c.target);
  if (!from->contains(a) || !to->contains(b)) {
    emit(std::string(c.call) + ": a view reaches outside its texture");
    return;
  }
  auto extent = [](const TextureInfo& t, uint32_t mip) {
    return std::array{std::max(1u, t.desc.width >> mip), std::max(1u, t.desc.height >> mip),
                      std::max(1u, t.desc.depth >> mip)};
  };
  if (from->desc.format != to->desc.format || from->desc.samples != to->desc.samples ||
      a.mipEnd - a.baseMip != b.mipEnd - b.baseMip ||
      a.layerEnd - a.baseLayer != b.layerEnd - b.baseLayer ||
      extent(*from, a.baseMip) != extent(*to, b.baseMip))
    emit(std::string(c.call) + ": texture '" + from->desc.label + "' and texture '" +
         to->desc.label + "' differ in format, samples, extent, mips or layers");
}

std::string poolName(const QueryCheck& c) {
  const QueryPoolDesc* pool = c.state.find(c.pool);
  return (pool ? "query pool '" + pool->label + "'"
               : std::string("a query pool that does not exist")) +
         ", index " + std::to_string(c.index) + ": ";
}

void queryIndex(const QueryCheck& c, const Emit& emit) {
  if (c.call == QueryCall::EndOfPass) return;
  const QueryPoolDesc* pool = c.state.find(c.pool);
  if (!pool || c.index >= pool->count) emit(poolName(c) + "out of range");
}

void queryKind(const QueryCheck& c, const Emit& emit) {
  const QueryPoolDesc* pool = c.state.find(c.pool);
  if (pool && (pool->kind == QueryKind::Timestamp) != (c.call == QueryCall::Timestamp))
    emit(poolName(c) + "a timestamp pool takes timestamps, and nothing else does");
}

void queryBalance(const QueryCheck& c, const Emit& emit) {
  const std::pair key = {c.pool.value, c.index};
  if (c.call == QueryCall::Begin && c.state.openQueries.contains(key))
    emit(poolName(c) + "begun twice");
  if (c.call == QueryCall::End && !c.state.openQueries.contains(key))
    emit(poolName(c) + "ended without a begin");
  if (c.call == QueryCall::EndOfPass)
    for (const auto& [pool, index] : c.state.openQueries)
      emit(poolName({c.state, c.call, {pool}, index}) + "still open at the end of its pass");
}

void queryReuse(const QueryCheck& c, const Emit& emit) {
  const bool starts = c.call == QueryCall::Begin || c.call == QueryCall::Timestamp;
  if (starts && c.state.usedQueries.contains({c.pool.value, c.index}))
    emit(poolName(c) + "used twice in one frame");
}

constexpr Rule<TransferCheck> kTransferRules[] = {
    {"transfer-range", transferRange},
    {"transfer-flag", transferFlag},
    {"region-bounds", regionBounds},
    {"copy-match", copyMatch},
};

constexpr Rule<QueryCheck> kQueryRules[] = {
    {"query-index", queryIndex},
    {"query-kind", queryKind},
    {"query-balance", queryBalance},
    {"query-reuse", queryReuse},
};

}  // namespace

std::span<const Rule<TransferCheck>> transferRules() { return kTransferRules; }
std::span<const Rule<QueryCheck>> queryRules() { return kQueryRules; }

}  // namespace rhi::validate
