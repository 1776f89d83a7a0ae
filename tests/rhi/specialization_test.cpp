// Specialization constants of every type, as loop bounds, array lengths and work-group sizes.
#include <bit>

#include "backends/rhi/error.h"
#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

namespace {

std::vector<uint32_t> runSpecialized(rhi::Device& device,
                                     std::vector<rhi::SpecConstant> constants) {
  rhi::Buffer out = bufferOf(device, std::vector<uint32_t>(7, 0));
  rhi::Pipeline pipeline = computePipeline(device, "specialize", std::move(constants));
  frame(device, [&](rhi::CommandList& list) {
    computePass(list, pipeline, {rhi::storageAt(0, out)}, {},
                {rhi::use(out, rhi::Access::StorageWrite)}, {2, 1, 1});
  });
  return readAll<uint32_t>(device, out);
}

uint32_t bits(float value) { return std::bit_cast<uint32_t>(value); }

}  // namespace

GPU_TEST(Specialization, DefaultsHold) {
  EXPECT_EQ(runSpecialized(device(), {{.id = 4, .bits = 1}}),
            (std::vector<uint32_t>{2, 0, 1, 2, bits(0.5f), 1, 9}));
}

GPU_TEST(Specialization, EveryTypeAndTheGroupSize) {
  EXPECT_EQ(runSpecialized(device(), {{0, 1}, {1, uint32_t(-7)}, {2, 0xFFFFFFFF}, {3, bits(0.1f)},
                                      {4, 16}, {5, 11}}),
            (std::vector<uint32_t>{32, 1, uint32_t(-7), 0xFFFFFFFF, bits(0.1f), 16, 100}));
}

GPU_TEST(Specialization, ExtremeValuesArriveBitByBit) {
  for (uint32_t integer : {0x80000000u, 0x7FFFFFFFu, 0u})
    EXPECT_EQ(runSpecialized(device(), {{1, integer}, {4, 1}})[2], integer);
  for (float value : {3.0f, -1e10f, 1.17549435e-38f, 3.4028235e38f, -2.5f, 16777217.0f})
    EXPECT_EQ(runSpecialized(device(), {{3, bits(value)}, {4, 1}})[4], bits(value)) << value;
}

GPU_TEST(Specialization, UndeclaredConstantIsAnError) {
  try {
    computePipeline(device(), "specialize", {{.id = 77, .bits = 1}});
    ADD_FAILURE() << "no error";
  } catch (const rhi::Error& error) {
    EXPECT_NE(std::string(error.what()).find("77"), std::string::npos) << error.what();
  }
  device().takeMessages();  // the RHI's own validation may have said so as well
}
