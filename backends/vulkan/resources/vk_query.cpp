#include "backends/vulkan/resources/vk_query.h"

#include <cassert>

#include "backends/rhi/device.h"

namespace vulkan {
namespace {

// Results come in bit order, which is the order that Device::readQueries promises.
constexpr VkQueryPipelineStatisticFlags kStatistics =
    VK_QUERY_PIPELINE_STATISTIC_INPUT_ASSEMBLY_VERTICES_BIT |
    VK_QUERY_PIPELINE_STATISTIC_INPUT_ASSEMBLY_PRIMITIVES_BIT |
    VK_QUERY_PIPELINE_STATISTIC_VERTEX_SHADER_INVOCATIONS_BIT |
    VK_QUERY_PIPELINE_STATISTIC_CLIPPING_INVOCATIONS_BIT |
    VK_QUERY_PIPELINE_STATISTIC_CLIPPING_PRIMITIVES_BIT |
    VK_QUERY_PIPELINE_STATISTIC_FRAGMENT_SHADER_INVOCATIONS_BIT |
    VK_QUERY_PIPELINE_STATISTIC_COMPUTE_SHADER_INVOCATIONS_BIT;

void requireSupport(const Context& context, const rhi::QueryPoolDesc& desc) {
  auto require = [&](bool present, rhi::Feature feature) {
    if (!present)
      throw rhi::Error("createQueryPool", "VK_ERROR_FEATURE_NOT_PRESENT",
                       "'" + desc.label + "' needs " + std::string(rhi::featureName(feature)));
  };
  if (desc.kind == rhi::QueryKind::PipelineStatistics)
    require(context.features().pipelineStatisticsQuery, rhi::Feature::PipelineStatistics);
  if (desc.kind == rhi::QueryKind::Occlusion)
    require(context.features().occlusionQueryPrecise, rhi::Feature::PreciseOcclusion);
  if (desc.kind == rhi::QueryKind::Timestamp && context.physical().info.limits.timestampBits == 0)
    throw rhi::Error("createQueryPool", "", "'" + desc.label + "': the queue has no timestamps");
}

}  // namespace

QueryPool createQueryPool(const Context& context, const rhi::QueryPoolDesc& desc) {
  requireSupport(context, desc);
  static constexpr VkQueryType kTypes[] = {VK_QUERY_TYPE_TIMESTAMP, VK_QUERY_TYPE_OCCLUSION,
                                           VK_QUERY_TYPE_PIPELINE_STATISTICS};
  const bool statistics = desc.kind == rhi::QueryKind::PipelineStatistics;
  const VkQueryPoolCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
      .queryType = kTypes[size_t(desc.kind)],
      .queryCount = desc.count,
      .pipelineStatistics = statistics ? kStatistics : 0,
  };
  QueryPool pool;
  pool.desc = desc;
  pool.used.resize(desc.count);
  check(context.vk.vkCreateQueryPool(context.device, &info, nullptr, &pool.handle),
        "vkCreateQueryPool", desc.label);
  context.name(pool.handle, VK_OBJECT_TYPE_QUERY_POOL, desc.label);
  context.vk.vkResetQueryPool(context.device, pool.handle, 0, desc.count);
  return pool;
}

void readQueries(const Context& context, const QueryPool& pool, uint32_t first, uint32_t count,
                 std::span<uint64_t> out) {
  assert(first + count <= pool.desc.count);
  const VkDeviceSize stride = out.size_bytes() / count;
  check(
      context.vk.vkGetQueryPoolResults(context.device, pool.handle, first, count, out.size_bytes(),
                                       out.data(), stride, VK_QUERY_RESULT_64_BIT),
      "vkGetQueryPoolResults", "'" + pool.desc.label + "'");
}

}  // namespace vulkan
