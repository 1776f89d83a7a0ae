// Shaders and the truth mean the same medium: lattice bit for bit, density and phase function to
// what floats can tell.
#include "suites/scenes/procedural/parts/random.h"
#include "techniques/scene/medium_data.h"
#include "tests/rhi/resource_helpers.h"

using namespace sb;
using namespace sb::test;

GPU_TEST(SharedMedium, ShaderAndTruthAgree) {
  std::vector<Medium> media;
  for (uint32_t i = 0; i < 3; ++i) {
    media.push_back({.kind = MediumKind::Smoke,
                     .anisotropy = 0.4f * float(i) - 0.4f,
                     .seed = 1000 * i,
                     .time = 123.4 * i});
    media[i].boxToWorld = glm::dmat4(0, 2, 0, 0, 0, 0, 2, 0, 2, 0, 0, 0, 1e6, -1, -1, 1);
  }
  const glm::dvec3 eye(1e6 + 1, 0, 0);
  const gpu::MediaBlock block = mediaBlock(media, eye);
  Pcg random(3);
  std::vector<glm::vec4> inputs;
  while (inputs.size() < 4096)
    inputs.emplace_back(glm::dvec4(random.uniform(-1, 1), random.uniform(-1, 1),
                                   random.uniform(-1, 1), random.uniform(-1, 1)));
  rhi::Pipeline pipeline = device().createPipeline(rhi::ComputePipelineDesc{
      .label = "medium", .compute = &testShaders().get("techniques/medium.comp")});
  rhi::Buffer uniform = bufferOf(device(), std::vector<gpu::MediaBlock>{block});
  rhi::Buffer in = bufferOf(device(), inputs);
  rhi::Buffer out = bufferOf(device(), std::vector<glm::vec4>(inputs.size()));
  frame(device(), [&](rhi::CommandList& list) {
    computePass(
        list, pipeline,
        {rhi::uniformAt(UNIFORM_MEDIA, uniform), rhi::storageAt(0, in), rhi::storageAt(1, out)},
        {rhi::use(in.id(), rhi::Access::StorageRead)},
        {rhi::use(out.id(), rhi::Access::StorageWrite)}, {64, 1, 1});
  });
  const auto answers = readAll<glm::vec4>(device(), out);
  size_t smoky = 0;
  for (uint32_t i = 0; i < inputs.size(); ++i) {
    const Medium& m = media[i % 3];
    const glm::dvec4 place = toBox(m, eye) * glm::dvec4(glm::dvec3(inputs[i]), 1);
    const double density = gpu::smokeDensity(smokeShape(m), glm::dvec3(place));
    smoky += density > 0;
    ASSERT_NEAR(answers[i].x, density, 2e-5) << i;
    ASSERT_EQ(answers[i].y, float(gpu::latticeValue({i, i * 7u, ~i}, m.seed))) << i;
    const double phase = gpu::henyeyGreenstein(double(m.anisotropy), double(inputs[i].w));
    ASSERT_NEAR(answers[i].z, phase, 1e-5 * phase) << i;
    ASSERT_NEAR(answers[i].w, gpu::sinTurns(double(inputs[i].x)), 1e-6) << i;
  }
  EXPECT_GT(smoky, 300u);
}
