#include "suites/harness/group.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "reports/stats/stats.h"
#include "suites/harness/compare.h"
#include "suites/harness/load_watch.h"
#include "suites/harness/scene_hash.h"
#include "suites/harness/verify.h"
#include "suites/scenes/analysis.h"
#include "suites/scenes/procedural.h"

namespace sb {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void addOnce(std::vector<std::string>& list, const std::string& text) {
  if (std::ranges::find(list, text) == list.end()) list.push_back(text);
}

report::Record recordOf(const CellId& id, const std::string& sceneHash,
                        const std::string& version) {
  report::Record r = {.name = cellName(id),
                      .technique = id.technique,
                      .transparency = id.transparency,
                      .backend = id.backend,
                      .scene = id.scene,
                      .sceneHash = sceneHash,
                      .width = id.width,
                      .height = id.height,
                      .seed = id.seed,
                      .version = version,
                      .command = cellCommand(id)};
  const Knobs knobs = cellKnobs(id);
  for (const auto& [name, value] : knobs.all()) r.knobs[name] = value;
  for (const char* key : {"visibility", "image", "noise", "truth_stderr"})
    r.why[key] = "no ray-traced truth in this version";
  return r;
}

void recordPlan(const Plan& plan, report::Record& record) {
  for (Effect e : plan.planned.list()) record.effectsPlanned.emplace_back(effectName(e));
  for (const auto& [e, why] : plan.skipped)
    record.effectsSkipped.emplace_back(std::string(effectName(e)), why);
  for (Effect e : plan.unrepresented) record.effectsUnrepresented.emplace_back(effectName(e));
}

/// A cell under measurement.
struct Active {
  CellResult* result = nullptr;
  DeviceSession* device = nullptr;
  std::unique_ptr<Renderer> renderer;
  Samples samples;
  std::string untimedPicture;  ///< content hash
  uint32_t framesPerBlock = 1;
  bool software = true;
  bool ok() const { return result->record.status == report::Status::Ok; }
};

class Group {
 public:
  Group(const std::vector<CellId>& cells, Devices& devices, const MeasureSettings& settings,
        const std::string& version)
      : m_devices(devices), m_settings(settings) {
    m_scene = makeScene(cells.front().scene);
    const double aspect = double(cells.front().width) / double(cells.front().height);
    m_effects = analyse(m_scene, aspect);
    const std::string hash = sceneHash(m_scene);
    for (const CellId& id : cells) m_results.push_back({id, recordOf(id, hash, version), {}});
    m_active.reserve(m_results.size());
  }

  std::vector<CellResult> run() {
    for (size_t i = 0; i < m_results.size(); ++i) {
      report("prepare", 0.3 * double(i) / double(m_results.size()));
      guarded(m_results[i], [&] { prepare(m_results[i]); });
      if (interrupted()) return {};
    }
    const MachineUse before = machineUse();
    const Stop stop = measureBlocks();
    if (interrupted()) return {};
    const std::vector<std::string> disturbed = disturbances(before, machineUse());
    for (size_t i = 0; i < m_active.size(); ++i) {
      report("verify", 0.9 + 0.1 * double(i) / double(m_active.size()));
      Active& a = m_active[i];
      for (const std::string& d : disturbed) addOnce(a.result->record.contamination, d);
      guarded(*a.result, [&] { finish(a, stop); });
      if (interrupted()) return {};
    }
    std::vector<Measured> measured;
    for (Active& a : m_active) measured.push_back({a.result, &a.samples, a.software});
    compareCells(measured);
    return std::move(m_results);
  }

 private:
  bool interrupted() const { return m_settings.interrupted && m_settings.interrupted->load(); }
  void report(const std::string& what, double done) const {
    if (m_settings.progress) m_settings.progress(what, done);
  }

  /// A failure of one cell is its record's, not the run's.
  template <class Work>
  void guarded(CellResult& result, const Work& work) {
    if (result.record.status != report::Status::Ok) return;
    try {
      work();
    } catch (const std::exception& e) {
      report::refuse(result.record, e.what());
    }
  }

  static void skip(report::Record& record, const std::string& reason) {
    record.status = report::Status::Skipped;
    record.reason = reason;
  }

  void prepare(CellResult& result) {
    report::Record& record = result.record;
    DeviceSession* session = m_devices.open(result.id.backend);
    if (!session)
      return skip(record, "the backend does not start: " + m_devices.why(result.id.backend));
    rhi::Device& device = *session->device;
    record.device = device.info().name;
    record.deviceType = rhi::deviceTypeName(device.info().type);
    record.driver = device.info().driver + " " + device.info().driverVersion;
    const ShadowEntry& technique = shadowTechnique(result.id.technique);
    const TransparencyEntry& transparency = transparencyTechnique(result.id.transparency);
    if (auto why = unsupported(device, technique.info, transparency.info))
      return skip(record, why->reason);
    Active a;
    a.result = &result;
    a.device = session;
    a.software = device.isSoftware();
    if (m_settings.checkTimers) {
      const auto& facts = Devices::timersOf(*session);
      if (const auto why = whyUntrusted(facts, TimerUse::Frame); !why.empty())
        return report::refuse(record, why);
      a.samples.passesUntrusted = whyUntrusted(facts, TimerUse::Passes);
    }
    auto& gpuScene = m_gpuScenes[session];
    if (!gpuScene) gpuScene = std::make_unique<GpuScene>(device, m_scene);
    const double createdBefore = session->pipelines->createMs();
    a.renderer =
        std::make_unique<Renderer>(session->context(), *gpuScene, m_effects,
                                   RendererDesc{.technique = &technique,
                                                .transparency = &transparency,
                                                .knobs = cellKnobs(result.id),
                                                .size = {result.id.width, result.id.height},
                                                .seed = result.id.seed,
                                                .forced = {}});
    recordPlan(a.renderer->plan(), record);
    record.bytesByLabel = a.renderer->bytesByLabel();
    for (const auto& [label, bytes] : record.bytesByLabel) record.bytes += bytes;
    warmUp(a, session->pipelines->createMs() - createdBefore);
    a.untimedPicture = contentHashOf(readPicture(a));
    takeMessages(a);
    m_active.push_back(std::move(a));
  }

  /// Every pipeline and state is drawn twice before the windows begin.
  void warmUp(Active& a, double createMs) {
    const double first = a.renderer->frame().wallMs;
    a.renderer->frame(FrameMode::Stamped);
    a.renderer->frame(FrameMode::Counted);
    WarmUp rule;
    for (bool done = false; !done && !interrupted();) {
      std::vector<double> times;
      for (int i = 0; i < WarmUp::kWindowFrames; ++i)
        times.push_back(rankingMs(a.renderer->frame(), a.software));
      done = rule.add(report::median(times));
    }
    if (!rule.steady())
      a.result->record.warnings.push_back("ten warm-up windows did not agree: the time drifts");
    const double warm = a.renderer->frame().wallMs;
    a.samples.compileMs = createMs + std::max(0.0, first - warm);
    a.framesPerBlock =
        uint32_t(std::clamp(m_settings.blockSeconds * 1e3 / std::max(warm, 1e-3), 1.0, 32.0));
  }

  report::Picture readPicture(Active& a) {
    return {a.result->id.width, a.result->id.height, a.renderer->readImage()};
  }

  Stop measureBlocks() {
    const auto start = Clock::now();
    const double budget = m_settings.budgetSeconds * double(m_active.size());
    for (uint32_t round = 0; !m_active.empty(); ++round) {
      for (size_t i : roundOrder(m_active.size(), round)) {
        Active& a = m_active[i];
        guarded(*a.result, [&] { measureBlock(a); });
        if (interrupted()) break;
      }
      const double spent = secondsSince(start) / std::max(1e-9, budget);
      report("measure", 0.3 + 0.6 * std::min(1.0, spent));
      std::vector<double> widths;
      for (const Active& a : m_active)
        if (a.ok()) widths.push_back(relativeHalfWidth(blockMeans(a.samples, a.software)));
      const Stop stop = stopNow(m_settings.stop, round + 1, spent, widths);
      if (stop != Stop::Not || interrupted()) return stop;
    }
    return Stop::Not;
  }

  void measureBlock(Active& a) {
    SampleBlock block;
    const size_t pipelines = a.device->pipelines->size();
    for (uint32_t i = 0; i < a.framesPerBlock; ++i) block.frames.push_back(a.renderer->frame());
    if (a.device->pipelines->size() != pipelines)
      addOnce(a.result->record.contamination, "a pipeline was created within a timed frame");
    a.samples.blocks.push_back(std::move(block));
    takeMessages(a);
  }

  /// What a device's validation said since the last call belongs to the cell that ran.
  static void takeMessages(Active& a) {
    for (const rhi::Message& m : a.device->device->takeMessages())
      addOnce(a.result->record.warnings, "validation: " + m.source + " [" + m.rule + "] " + m.text);
  }

  void finish(Active& a, Stop stop) {
    CellResult& result = *a.result;
    report::Record& record = result.record;
    // The picture first: it must be of the last timed frame.
    result.picture = readPicture(a);
    record.picture = contentHashOf(result.picture);
    record.stable = record.picture == a.untimedPicture;
    record.nonfinite = countNonFinite(result.picture);
    for (uint32_t i = 0; i < m_settings.stampedFrames; ++i)
      a.samples.stamped.push_back(a.renderer->frame(FrameMode::Stamped));
    a.samples.counted = a.renderer->frame(FrameMode::Counted);
    takeMessages(a);
    summarise(a.samples, a.software, record);
    record.precision = relativeHalfWidth(blockMeans(a.samples, a.software));
    record.stoppedBy = stop == Stop::Precision ? "precision"
                       : stop == Stop::Budget  ? "budget"
                                               : "repetitions";
    if (m_devices.validating()) addOnce(record.contamination, "validation is on");
#ifndef NDEBUG
    addOnce(record.contamination, "this is a debug build");
#endif
    if (isUniform(result.picture)) addOnce(record.warnings, "the picture has a single colour");
    if (const std::string why = whyRefused(record); !why.empty()) report::refuse(record, why);
  }

  Devices& m_devices;
  const MeasureSettings& m_settings;
  Scene m_scene;
  Effects m_effects;
  std::vector<CellResult> m_results;
  std::map<DeviceSession*, std::unique_ptr<GpuScene>> m_gpuScenes;
  std::vector<Active> m_active;
};

}  // namespace

std::vector<CellResult> measureGroup(const std::vector<CellId>& cells, Devices& devices,
                                     const MeasureSettings& settings, const std::string& version) {
  return Group(cells, devices, settings, version).run();
}

}  // namespace sb
