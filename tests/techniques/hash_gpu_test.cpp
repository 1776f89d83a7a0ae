// The random numbers of shaders and of the CPU are the same bits.
#include "shaders/common/shared_hash.h"
#include "suites/scenes/procedural/parts/random.h"
#include "tests/rhi/resource_helpers.h"

using namespace sb;
using namespace sb::test;

GPU_TEST(SharedHash, ShaderAndCpuAgreeOnEveryBit) {
  std::vector<glm::uvec4> inputs = {{0, 0, 0, 0}, {65535, 65535, ~0u, ~0u}, {1, 2, 3, 4}};
  Pcg random(7);
  while (inputs.size() < 65536)
    inputs.emplace_back(random.below(65536), random.below(65536), random.next(), random.next());
  rhi::Pipeline pipeline = device().createPipeline(rhi::ComputePipelineDesc{
      .label = "hash", .compute = &testShaders().get("techniques/hash.comp")});
  rhi::Buffer in = bufferOf(device(), inputs);
  rhi::Buffer out = bufferOf(device(), std::vector<glm::uvec4>(inputs.size()));
  frame(device(), [&](rhi::CommandList& list) {
    computePass(list, pipeline, {rhi::storageAt(0, in), rhi::storageAt(1, out)},
                {rhi::use(in.id(), rhi::Access::StorageRead)},
                {rhi::use(out.id(), rhi::Access::StorageWrite)}, {1024, 1, 1});
  });
  const auto answers = readAll<glm::uvec4>(device(), out);
  for (size_t i = 0; i < inputs.size(); ++i) {
    const glm::uvec4 v = inputs[i];
    const glm::vec4 expected =
        gpu::randomNumbers(v.x, v.y, gpu::surfaceKey(v.z, v.w, v.x), v.z & 3u, v.w);
    ASSERT_EQ(answers[i], glm::floatBitsToUint(expected)) << i;
  }
}
