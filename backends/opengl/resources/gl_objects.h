// All objects of a device by id.
#pragma once

#include "backends/opengl/pipeline/gl_pipeline.h"
#include "backends/opengl/resources/gl_buffer.h"
#include "backends/opengl/resources/gl_query.h"
#include "backends/opengl/resources/gl_sampler.h"
#include "backends/opengl/resources/gl_texture.h"
#include "backends/rhi/pool.h"

namespace opengl {

struct Objects {
  rhi::Pool<rhi::BufferTag, Buffer> buffers;
  rhi::Pool<rhi::TextureTag, Texture> textures;
  rhi::Pool<rhi::SamplerTag, Sampler> samplers;
  rhi::Pool<rhi::PipelineTag, Pipeline> pipelines;
  rhi::Pool<rhi::QueryPoolTag, QueryPool> queryPools;
};

}  // namespace opengl
