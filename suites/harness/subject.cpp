#include "suites/harness/subject.h"

#include <ctime>
#include <fstream>
#include <numeric>

#include "suites/truth/tracer.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

/// A technique on a device.
class RendererSubject final : public Subject {
 public:
  RendererSubject(const CellId& id, DeviceSession& session, Stage& stage,
                  std::string passesUntrusted)
      : m_id(id),
        m_session(session),
        m_createdBefore(session.pipelines->createMs()),
        m_renderer(stage.renderer(session.context(), rendererDesc(id))),
        m_passesUntrusted(std::move(passesUntrusted)) {}

  FrameResult frame(FrameMode mode) override { return m_renderer->frame(mode); }
  uint32_t steps() const override { return m_renderer->steps(); }
  report::Picture picture() override { return {m_id.width, m_id.height, m_renderer->readImage()}; }
  bool software() const override { return m_session.device->isSoftware(); }
  double createMs() const override { return m_session.pipelines->createMs() - m_createdBefore; }
  size_t pipelines() const override { return m_session.pipelines->size(); }
  std::vector<rhi::Message> takeMessages() override { return m_session.device->takeMessages(); }
  std::string passesUntrusted() const override { return m_passesUntrusted; }
  std::vector<std::string> warnings() override { return m_renderer->warnings(); }
  std::vector<std::pair<std::string, uint64_t>> counts() override { return m_renderer->counts(); }

  std::vector<uint32_t> lights() const override { return m_renderer->lights(); }
  std::vector<VisibilityImage> visibility(uint32_t light, uint32_t seed) override {
    return m_renderer->visibilityAtEnd(light, seed);
  }
  LookupReach reach(uint32_t light) const override { return m_renderer->reach(light); }
  std::string whyNotRandom() const override { return m_renderer->whyNotRandom(); }

  void describe(report::Record& record) const override {
    const Plan& plan = m_renderer->plan();
    for (Effect e : plan.planned.list()) record.effectsPlanned.emplace_back(effectName(e));
    for (const auto& [e, why] : plan.skipped)
      record.effectsSkipped.emplace_back(std::string(effectName(e)), why);
    for (Effect e : plan.unrepresented)
      record.effectsUnrepresented.emplace_back(effectName(e));
    record.bytesByLabel = m_renderer->bytesByLabel();
    for (const auto& [label, bytes] : record.bytesByLabel) record.bytes += bytes;
  }

 private:
  const CellId m_id;
  DeviceSession& m_session;
  const double m_createdBefore;
  std::unique_ptr<Renderer> m_renderer;
  std::string m_passesUntrusted;
};

/// The truth's tracer: one ray a pixel and the shadow rays that it calls for, on all CPUs.
class TracerSubject final : public Subject {
 public:
  TracerSubject(const CellId& id, const Scene& scene)
      : m_id(id),
        m_lights(uint32_t(scene.lights.size())),
        m_rays(cellKnobs(id).integer("rays")),
        m_start(clockMs(CLOCK_MONOTONIC)),
        m_tracer(scene, id.width, id.height) {
    m_createMs = clockMs(CLOCK_MONOTONIC) - m_start;
  }

  FrameResult frame(FrameMode) override {
    FrameResult result;
    const double wall = clockMs(CLOCK_MONOTONIC), cpu = clockMs(CLOCK_PROCESS_CPUTIME_ID);
    m_image = m_tracer.image(m_rays);
    result.wallMs = clockMs(CLOCK_MONOTONIC) - wall;
    result.cpuMs = clockMs(CLOCK_PROCESS_CPUTIME_ID) - cpu;
    return result;
  }
  report::Picture picture() override { return {m_id.width, m_id.height, m_image}; }
  bool software() const override { return true; }
  double createMs() const override { return m_createMs; }
  bool hasPasses() const override { return false; }
  std::string passesUntrusted() const override { return "ray tracing has no passes"; }
  std::vector<uint32_t> lights() const override {
    std::vector<uint32_t> lights(m_lights);
    std::iota(lights.begin(), lights.end(), 0u);
    return lights;
  }
  std::vector<VisibilityImage> visibility(uint32_t light, uint32_t) override {
    if (!m_answers)
      m_answers = m_tracer.trace(
          {.width = m_id.width, .height = m_id.height, .sampling = {.pattern = m_rays}});
    const auto first = m_answers->visibility.begin() + ptrdiff_t(light) * kTruthLayers;
    std::vector<VisibilityImage> layers(first, first + kTruthLayers);
    // A visibility buffer has an answer wherever a surface is, asked for or not.
    for (uint32_t layer = 0; layer < kTruthLayers; ++layer)
      for (size_t p = 0; p < m_answers->surfaces[layer].size(); ++p)
        if (m_answers->surfaces[layer][p] > 0) layers[layer][4 * p + 3] = 1;
    return layers;
  }
  void describe(report::Record& record) const override {
    record.bytes = m_tracer.bytes();
    record.bytesByLabel["triangles and tree"] = record.bytes;
  }

 private:
  static double clockMs(clockid_t id) {
    timespec t{};
    clock_gettime(id, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
  }

  const CellId m_id;
  const uint32_t m_lights, m_rays;
  const double m_start;
  Tracer m_tracer;
  double m_createMs = 0;
  std::vector<float> m_image;
  std::optional<Truth> m_answers;  ///< traced when asked for, outside what is timed
};

std::string cpuName() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "CPU";
}

std::unique_ptr<Subject> skip(report::Record& record, const std::string& reason) {
  record.status = report::Status::Skipped;
  record.reason = reason;
  return nullptr;
}

}  // namespace

std::unique_ptr<Subject> makeSubject(const CellId& id, SubjectContext& context,
                                     report::Record& record) {
  if (isReference(id)) {
    record.device = cpuName();
    record.deviceType = rhi::deviceTypeName(rhi::DeviceType::Software);
    record.driver = "the truth's tracer";
    if (!context.stage.scene().path.empty())
      record.warnings.push_back(
          "nothing moves before the tracer: it traces the last frame of the path again and again");
    return std::make_unique<TracerSubject>(id, context.stage.scene());
  }
  DeviceSession* session = context.devices.open(id.backend);
  if (!session)
    return skip(record, "the backend does not start: " + context.devices.why(id.backend));
  if (const std::string lost = context.devices.whyLost(id.backend); !lost.empty()) {
    report::refuse(record, lost);
    return nullptr;
  }
  rhi::Device& device = *session->device;
  record.device = device.info().name;
  record.deviceType = rhi::deviceTypeName(device.info().type);
  record.driver = device.info().driver + " " + device.info().driverVersion;
  if (auto why = context.stage.unsupported(device, rendererDesc(id)))
    return skip(record, why->reason);
  std::string passesUntrusted;
  if (context.checkTimers) {
    const auto& facts = Devices::timersOf(*session);
    if (const auto why = whyUntrusted(facts, TimerUse::Frame); !why.empty()) {
      report::refuse(record, why);
      return nullptr;
    }
    passesUntrusted = whyUntrusted(facts, TimerUse::Passes);
  }
  return std::make_unique<RendererSubject>(id, *session, context.stage,
                                           std::move(passesUntrusted));
}

}  // namespace sb
