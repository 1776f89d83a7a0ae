#include "tests/rhi/resource_helpers.h"

namespace sb::test {

std::vector<Vec4> sampleAt(rhi::Device& device, const std::string& shader,
                           const rhi::TextureView& view, rhi::SamplerDesc sampler,
                           const std::vector<Vec4>& at) {
  if (sampler.label.empty()) sampler.label = "test sampler";
  rhi::Sampler object = device.createSampler(sampler);
  rhi::Buffer in = bufferOf(device, at);
  rhi::Buffer out = bufferOf(device, std::vector<Vec4>(at.size(), Vec4{-1, -1, -1, -1}));
  rhi::Pipeline pipeline = computePipeline(device, shader);
  frame(device, [&](rhi::CommandList& list) {
    computePass(list, pipeline,
                {rhi::textureAt(0, view, object), rhi::storageAt(0, in), rhi::storageAt(1, out)},
                {rhi::use(view, rhi::Access::Sampled), rhi::use(in, rhi::Access::StorageRead)},
                {rhi::use(out, rhi::Access::StorageWrite)}, {uint32_t(at.size()), 1, 1});
  });
  return readAll<Vec4>(device, out);
}

}  // namespace sb::test
