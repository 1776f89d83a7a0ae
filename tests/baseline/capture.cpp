#include "tests/baseline/capture.h"

#include "backends/null/null_backend.h"
#include "suites/harness/stage.h"

namespace sb::baseline {
namespace {

class Recorder final : public rhi::Observer {
 public:
  Capture capture;

  void created(rhi::BufferId id, const rhi::BufferDesc& d) override {
    capture.buffers[id] = {d, {}};
  }
  void created(rhi::TextureId id, const rhi::TextureDesc& d) override {
    capture.textures[id] = d;
    if (d.label == "camera colour") capture.picture = id;
  }
  void created(rhi::SamplerId id, const rhi::SamplerDesc& d) override { capture.samplers[id] = d; }
  void created(rhi::PipelineId id, const rhi::GraphicsPipelineDesc& d) override {
    capture.pipelines[id] = d;
  }
  void destroyed(rhi::BufferId id) override {
    if (!m_done) capture.buffers.erase(id);
  }
  void destroyed(rhi::TextureId id) override {
    if (!m_done) capture.textures.erase(id);
  }
  void beginFrame() override { capture.passes.clear(); }
  void beginPass(const rhi::PassDesc& d) override {
    capture.passes.push_back({d.label, {d.colors.begin(), d.colors.end()}, d.depth, {}});
  }
  void drawIndexed(const rhi::DrawState& s, const rhi::DrawIndexedArgs& args) override {
    capture.passes.back().draws.push_back({s.pipeline,
                                           {s.bindings.begin(), s.bindings.end()},
                                           {s.vertexBuffers.begin(), s.vertexBuffers.end()},
                                           s.indexBuffer,
                                           args});
  }

  void finish(rhi::Device& device) {
    for (auto& [id, buffer] : capture.buffers) buffer.bytes = device.read(id, 0, buffer.desc.size);
    m_done = true;
  }

 private:
  bool m_done = false;
};

}  // namespace

Capture captureShadowMap(const Scene& scene, const rhi::ShaderLibrary& shaders,
                         rhi::Extent2D size) {
  const auto device = null_backend::makeBackend()->open({});
  Recorder recorder;
  device->setObserver(&recorder);
  {
    PipelineCache pipelines(*device);
    FrameQueries queries(*device);
    Stage stage(scene, size);
    const auto renderer = stage.renderer(
        {*device, shaders, pipelines, queries},
        rendererDesc({.technique = "ShadowMap", .width = size.width, .height = size.height}));
    renderer->frame();
    recorder.finish(*device);
  }
  device->setObserver(nullptr);
  return std::move(recorder.capture);
}

}  // namespace sb::baseline
