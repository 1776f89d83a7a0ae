#include "techniques/render/opaque_surfaces.h"

#include <algorithm>

#include "techniques/render/camera_pass.h"

namespace sb {

OpaqueSurfaces::OpaqueSurfaces(const Context& context, const CameraPass& camera) {
  refill(camera);
  for (Bucket& bucket : m_buckets)
    bucket.pipelines = m_pipelines[{bucket.masked, bucket.doubleSided}] =
        makePipelines(context, camera, bucket);
}

OpaqueSurfaces::Pipelines OpaqueSurfaces::makePipelines(const Context& context,
                                                        const CameraPass& camera,
                                                        const Bucket& bucket) const {
  const rhi::CullMode cull = bucket.doubleSided ? rhi::CullMode::None : rhi::CullMode::Back;
  rhi::GraphicsPipelineDesc shaded = camera.surfacePipeline(
      bucket.masked ? "masked" : "opaque",
      camera.shaded(CameraPass::Receivers::Opaque, "", "forward.frag"),
      // Where depth was drawn before, that alone has decided what the mask leaves.
      bucket.masked && !camera.byLayer());
  shaded.raster.cull = cull;
  Pipelines pipelines;
  if (camera.byLayer()) {
    // Of surfaces at one depth the first one drawn shows, as where depth is written while shading:
    // the stencil counts.
    const rhi::StencilFace first = {.compare = rhi::CompareOp::Equal,
                                    .pass = rhi::StencilOp::IncrementClamp};
    shaded.depth = {.test = true, .write = false, .compare = rhi::CompareOp::Equal};
    shaded.stencil = {.test = true, .front = first, .back = first};
    rhi::GraphicsPipelineDesc depth = camera.unshadedPipeline("common/surface_mask.frag");
    if (!bucket.masked) {
      depth.fragment = nullptr;
      depth.constants.clear();
    }
    depth.depth = {.test = true, .write = true, .compare = CameraPass::kNearer};
    depth.depthFormat = camera.depthFormat();
    depth.raster.cull = cull;
    pipelines.depth = context.pipeline(depth);
  }
  pipelines.shaded = context.pipeline(shaded);
  return pipelines;
}

void OpaqueSurfaces::refill(const CameraPass& camera) {
  m_buckets.clear();
  const Scene& scene = camera.view().scene();
  for (const uint32_t i : camera.view().effects().visibleOpaque) {
    const Material& material = scene.materials[scene.meshes[scene.instances[i].mesh].material];
    const bool masked = material.alphaMode == AlphaMode::Mask;
    auto bucket = std::ranges::find_if(m_buckets, [&](const Bucket& b) {
      return b.masked == masked && b.doubleSided == material.doubleSided;
    });
    if (bucket == m_buckets.end())
      bucket = m_buckets.insert(bucket, {.masked = masked,
                                         .doubleSided = material.doubleSided,
                                         .pipelines = m_pipelines[{masked, material.doubleSided}],
                                         .instances = {}});
    bucket->instances.push_back(i);
  }
}

void OpaqueSurfaces::drawDepth(rhi::CommandList& commands, DrawList& draws) const {
  for (const Bucket& b : m_buckets) draws.draw(commands, b.pipelines.depth, b.instances);
}

void OpaqueSurfaces::drawShaded(rhi::CommandList& commands, DrawList& draws) const {
  for (const Bucket& b : m_buckets) draws.draw(commands, b.pipelines.shaded, b.instances);
}

void OpaqueSurfaces::drawWith(rhi::CommandList& commands, DrawList& draws,
                              rhi::PipelineId singleSided, rhi::PipelineId doubleSided) const {
  for (const Bucket& b : m_buckets)
    draws.draw(commands, b.doubleSided ? doubleSided : singleSided, b.instances);
}

}  // namespace sb
