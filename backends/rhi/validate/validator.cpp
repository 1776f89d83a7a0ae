#include "backends/rhi/validate/validator.h"

#include <algorithm>

#include "backends/rhi/validate/rules.h"

namespace rhi {

using namespace validate;

namespace {

void merge(std::vector<ShaderResource>& into, const ShaderCode* stage) {
  if (!stage) return;
  for (const ShaderResource& resource : stage->resources) {
    auto same = [&](const ShaderResource& r) { return r.slot == resource.slot; };
    auto it = std::ranges::find_if(into, same);
    if (it == into.end())
      into.push_back(resource);
    else
      it->readOnly &= resource.readOnly;
  }
}

bool writesStencil(const GraphicsPipelineDesc& desc) {
  auto keeps = [](const StencilFace& f) {
    return f.fail == StencilOp::Keep && f.depthFail == StencilOp::Keep && f.pass == StencilOp::Keep;
  };
  return desc.stencil.test && desc.stencil.writeMask != 0 &&
         !(keeps(desc.stencil.front) && keeps(desc.stencil.back));
}

}  // namespace

Validator::Validator(Device& device) : m_device(device), m_state(std::make_unique<State>()) {
  m_state->info = &device.info();
  m_device.setObserver(this);
}

Validator::~Validator() { m_device.setObserver(nullptr); }

void Validator::report(const std::vector<Finding>& findings) {
  for (const Finding& finding : findings)
    if (m_reported.emplace(finding.rule, finding.text).second)
      m_device.report({"rhi", std::string(finding.rule), finding.text});
}

void Validator::created(BufferId id, const BufferDesc& desc) {
  m_state->buffers[id.value] = {desc, {}};
}
void Validator::created(TextureId id, const TextureDesc& desc) {
  m_state->textures[id.value] = {desc, std::vector<Content>(size_t(desc.mips) * desc.layers)};
}
void Validator::created(SamplerId id, const SamplerDesc& desc) {
  m_state->samplers[id.value] = desc;
}
void Validator::created(QueryPoolId id, const QueryPoolDesc& desc) {
  m_state->pools[id.value] = desc;
}

void Validator::created(PipelineId id, const GraphicsPipelineDesc& desc) {
  PipelineInfo info = {.label = desc.label,
                       .depthFormat = desc.depthFormat,
                       .writesDepth = desc.depth.test && desc.depth.write,
                       .writesStencil = writesStencil(desc),
                       .samples = desc.samples,
                       .vertexBuffers = desc.vertexBuffers,
                       .attributes = desc.attributes};
  for (const ShaderCode* stage : {desc.vertex, desc.geometry, desc.fragment})
    merge(info.resources, stage);
  for (const ColorTargetState& target : desc.targets) info.targets.push_back(target.format);
  m_state->pipelines[id.value] = std::move(info);
}

void Validator::created(PipelineId id, const ComputePipelineDesc& desc) {
  PipelineInfo info = {.label = desc.label, .compute = true};
  merge(info.resources, desc.compute);
  m_state->pipelines[id.value] = std::move(info);
}

void Validator::destroyed(BufferId id) { m_state->buffers.erase(id.value); }
void Validator::destroyed(TextureId id) { m_state->textures.erase(id.value); }
void Validator::destroyed(SamplerId id) { m_state->samplers.erase(id.value); }
void Validator::destroyed(PipelineId id) { m_state->pipelines.erase(id.value); }
void Validator::destroyed(QueryPoolId id) { m_state->pools.erase(id.value); }

void Validator::beginFrame() {
  m_reported.clear();
  m_state->usedQueries.clear();
}

void Validator::abandonFrame() {
  m_state->pass.reset();
  m_state->openQueries.clear();
}

void Validator::beginPass(const PassDesc& desc) {
  m_state->pass = ActivePass{desc.label,
                             desc.compute,
                             {desc.colors.begin(), desc.colors.end()},
                             desc.depth,
                             {desc.reads.begin(), desc.reads.end()},
                             {desc.writes.begin(), desc.writes.end()},
                             desc.extent};
  std::vector<Finding> findings;
  runRules<PassCheck>(passRules(), {*m_state, *m_state->pass}, findings);
  report(findings);
}

void Validator::endPass() {
  run(QueryCheck{*m_state, QueryCall::EndOfPass});
  m_state->openQueries.clear();
  applyPass(*m_state);
  m_state->pass.reset();
}

void Validator::run(DrawCheck check) {
  check.state = m_state.get();
  check.pass = &*m_state->pass;
  check.pipeline = m_state->find(check.pipelineId);
  std::vector<Finding> findings;
  runRules(drawRules(), check, findings);
  runRules(bindingRules(), check, findings);
  report(findings);
}

void Validator::draw(const DrawState& state, const DrawArgs& args) {
  run({.pipelineId = state.pipeline, .bindings = state.bindings, .draw = &state, .direct = &args});
}

void Validator::drawIndexed(const DrawState& state, const DrawIndexedArgs& args) {
  run({.pipelineId = state.pipeline,
       .bindings = state.bindings,
       .draw = &state,
       .indexed = &args,
       .usesIndices = true});
}

void Validator::drawIndirect(const DrawState& state, const IndirectArgs& args, bool indexed) {
  run({.pipelineId = state.pipeline,
       .bindings = state.bindings,
       .draw = &state,
       .indirect = &args,
       .usesIndices = indexed});
}

void Validator::dispatch(const DispatchState& state, uint32_t, uint32_t, uint32_t) {
  run({.pipelineId = state.pipeline, .bindings = state.bindings});
}

void Validator::dispatchIndirect(const DispatchState& state, BufferId args, uint64_t offset) {
  const IndirectArgs indirect = {.buffer = args, .offset = offset};
  run({.pipelineId = state.pipeline, .bindings = state.bindings, .indirect = &indirect});
}

void Validator::run(const TransferCheck& check) {
  std::vector<Finding> findings;
  runRules(transferRules(), check, findings);
  report(findings);
}

void Validator::write(BufferId buffer, uint64_t offset, uint64_t size) {
  run(TransferCheck{
      .state = *m_state, .call = "write", .buffer = buffer, .offset = offset, .size = size});
  markTransferred(*m_state, buffer);
}

void Validator::fill(BufferId buffer, uint64_t offset, uint64_t size) {
  run(TransferCheck{
      .state = *m_state, .call = "fill", .buffer = buffer, .offset = offset, .size = size});
  markTransferred(*m_state, buffer);
}

void Validator::copy(BufferId source, uint64_t sourceOffset, BufferId target, uint64_t targetOffset,
                     uint64_t size) {
  run(TransferCheck{.state = *m_state,
                    .call = "copy",
                    .buffer = source,
                    .offset = sourceOffset,
                    .size = size,
                    .needs = BufferUse::CopySource});
  run(TransferCheck{.state = *m_state,
                    .call = "copy",
                    .buffer = target,
                    .offset = targetOffset,
                    .size = size,
                    .needs = BufferUse::CopyTarget});
  markTransferred(*m_state, target);
}

void Validator::copy(const TextureView& source, const TextureView& target) {
  run(TransferCheck{.state = *m_state, .call = "copy", .source = &source, .target = &target});
  markTransferred(*m_state, target);
}

void Validator::discard(TextureId texture) { markDiscarded(*m_state, texture); }

void Validator::upload(BufferId buffer, uint64_t offset, uint64_t size) {
  run(TransferCheck{
      .state = *m_state, .call = "upload", .buffer = buffer, .offset = offset, .size = size});
  markTransferred(*m_state, buffer);
}

void Validator::upload(TextureId texture, const TextureRegion& region, uint64_t) {
  run(TransferCheck{.state = *m_state, .call = "upload", .texture = texture, .region = region});
  const TextureInfo* info = m_state->find(texture);
  const bool volume = info && info->desc.kind == TextureKind::Tex3D;
  markTransferred(*m_state, {texture, region.mip, 1, volume ? 0 : region.layer, 1});
}

void Validator::read(BufferId buffer, uint64_t offset, uint64_t size) {
  run(TransferCheck{
      .state = *m_state, .call = "read", .buffer = buffer, .offset = offset, .size = size});
}

void Validator::read(TextureId texture, const TextureRegion& region) {
  run(TransferCheck{.state = *m_state, .call = "read", .texture = texture, .region = region});
}

void Validator::run(const QueryCheck& check) {
  std::vector<Finding> findings;
  runRules(queryRules(), check, findings);
  report(findings);
}

void Validator::timestamp(QueryPoolId pool, uint32_t index) {
  run(QueryCheck{*m_state, QueryCall::Timestamp, pool, index});
  m_state->usedQueries.insert({pool.value, index});
}

void Validator::beginQuery(QueryPoolId pool, uint32_t index) {
  run(QueryCheck{*m_state, QueryCall::Begin, pool, index});
  m_state->openQueries.insert({pool.value, index});
  m_state->usedQueries.insert({pool.value, index});
}

void Validator::endQuery(QueryPoolId pool, uint32_t index) {
  run(QueryCheck{*m_state, QueryCall::End, pool, index});
  m_state->openQueries.erase({pool.value, index});
}

}  // namespace rhi
