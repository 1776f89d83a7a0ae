#include "suites/harness/group.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "reports/stats/stats.h"
#include "suites/harness/verify.h"
#include "suites/scenes/analysis.h"
#include "suites/harness/scene_hash.h"
#include "suites/scenes/procedural.h"
#include "techniques/common/error.h"

namespace sb {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
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
    for (const CellId& id : cells) {
      CellResult& r = m_results.emplace_back();
      r.id = id;
      r.record = {.name = cellName(id), .technique = id.technique, .transparency = id.transparency,
                  .backend = id.backend, .scene = id.scene, .sceneHash = hash, .width = id.width,
                  .height = id.height, .seed = id.seed, .version = version,
                  .command = cellCommand(id)};
      for (const auto& [name, value] : cellKnobs(id).all()) r.record.knobs[name] = value;
      for (const char* key : {"visibility", "image", "noise", "truth_stderr"})
        r.record.why[key] = "no ray-traced truth in this version";
    }
  }

  std::vector<CellResult> run() {
    for (size_t i = 0; i < m_results.size(); ++i) {
      report("prepare", 0.3 * double(i) / double(m_results.size()));
      guarded(m_results[i], [&] { prepare(m_results[i]); });
      if (interrupted()) return {};
    }
    measureBlocks();
    if (interrupted()) return {};
    for (Active& a : m_active) guarded(*a.result, [&] { finish(a); });
    if (interrupted()) return {};
    compare();
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
    } catch (const rhi::Error& e) {
      result.record.status = report::Status::Failed;
      result.record.reason = e.what();
    }
  }

  void prepare(CellResult& result) {
    report::Record& record = result.record;
    Active a;
    a.result = &result;
    a.device = m_devices.open(result.id.backend);
    if (!a.device) {
      record.status = report::Status::Skipped;
      record.reason = "the backend does not start: " + m_devices.why(result.id.backend);
      return;
    }
    const rhi::DeviceInfo& info = a.device->device->info();
    record.device = info.name;
    record.deviceType = rhi::deviceTypeName(info.type);
    record.driver = info.driver + " " + info.driverVersion;
    a.software = a.device->device->isSoftware();
    const ShadowEntry& technique = shadowTechnique(result.id.technique);
    const TransparencyEntry& transparency = transparencyTechnique(result.id.transparency);
    if (auto skip = unsupported(*a.device->device, technique.info, transparency.info)) {
      record.status = report::Status::Skipped;
      record.reason = skip->reason;
      return;
    }
    auto& gpuScene = m_gpuScenes[a.device];
    if (!gpuScene) gpuScene = std::make_unique<GpuScene>(*a.device->device, m_scene);
    const double createdBefore = a.device->pipelines->createMs();
    a.renderer = std::make_unique<Renderer>(
        a.device->context(), *gpuScene, m_effects,
        RendererDesc{.technique = &technique,
                     .transparency = &transparency,
                     .knobs = cellKnobs(result.id),
                     .size = {result.id.width, result.id.height},
                     .seed = result.id.seed,
                     .forced = {}});
    recordPlan(a.renderer->plan(), record);
    record.bytesByLabel = a.renderer->bytesByLabel();
    for (const auto& [label, bytes] : record.bytesByLabel) record.bytes += bytes;
    warmUp(a, a.device->pipelines->createMs() - createdBefore);
    const report::Picture picture = readPicture(a);
    a.untimedPicture = contentHashOf(picture);
    m_active.push_back(std::move(a));
  }

  static void recordPlan(const Plan& plan, report::Record& record) {
    for (Effect e : plan.planned.list()) record.effectsPlanned.emplace_back(effectName(e));
    for (const auto& [e, why] : plan.skipped)
      record.effectsSkipped.emplace_back(std::string(effectName(e)), why);
    for (Effect e : plan.unrepresented) record.effectsUnrepresented.emplace_back(effectName(e));
  }

  /// Every pipeline and state is drawn twice and two successive windows agree, or ten windows.
  void warmUp(Active& a, double createMs) {
    constexpr int kWindows = 10, kWindowFrames = 3;
    const double first = a.renderer->frame().wallMs;
    a.renderer->frame(FrameMode::Stamped);
    a.renderer->frame(FrameMode::Counted);
    double previous = 0;
    bool steady = false;
    for (int w = 0; w < kWindows && !steady; ++w) {
      std::vector<double> times;
      for (int i = 0; i < kWindowFrames; ++i)
        times.push_back(rankingMs(a.renderer->frame(), a.software));
      const double now = report::median(times);
      steady = w > 0 && std::abs(now - previous) <= 0.2 * std::max(now, previous) + 0.05;
      previous = now;
      if (interrupted()) return;
    }
    if (!steady)
      a.result->record.warnings.push_back("ten warm-up windows did not agree: the time drifts");
    const double warm = a.renderer->frame().wallMs;
    a.samples.compileMs = createMs + std::max(0.0, first - warm);
    a.framesPerBlock =
        uint32_t(std::clamp(m_settings.blockSeconds * 1e3 / std::max(warm, 1e-3), 1.0, 32.0));
  }

  report::Picture readPicture(Active& a) {
    return {a.result->id.width, a.result->id.height, a.renderer->readImage()};
  }

  void measureBlocks() {
    const auto start = Clock::now();
    const double budget = m_settings.budgetSeconds * double(m_active.size());
    for (uint32_t round = 0; !m_active.empty(); ++round) {
      // A B .. then B A: drift hits all alike.
      for (size_t i = 0; i < m_active.size(); ++i) {
        Active& a = m_active[round % 2 ? m_active.size() - 1 - i : i];
        guarded(*a.result, [&] { measureBlock(a); });
        if (interrupted()) return;
      }
      const double spent = secondsSince(start) / std::max(1e-9, budget);
      report("measure", 0.3 + 0.6 * std::min(1.0, spent));
      const uint32_t done = round + 1;
      if (m_settings.blocks > 0 ? done >= m_settings.blocks
                                : done >= m_settings.minBlocks && (spent >= 1 || allPrecise()))
        break;
    }
  }

  void measureBlock(Active& a) {
    SampleBlock block;
    const size_t pipelines = a.device->pipelines->size();
    for (uint32_t i = 0; i < a.framesPerBlock; ++i) block.frames.push_back(a.renderer->frame());
    if (a.device->pipelines->size() != pipelines)
      addWarning(a, "contaminated: a pipeline was created within a timed frame");
    a.samples.blocks.push_back(std::move(block));
  }

  static void addWarning(Active& a, const std::string& text) {
    auto& warnings = a.result->record.warnings;
    if (std::ranges::find(warnings, text) == warnings.end()) warnings.push_back(text);
  }

  bool allPrecise() const {
    return std::ranges::all_of(m_active, [&](const Active& a) {
      if (a.result->record.status != report::Status::Ok) return true;
      return halfWidth(a) <= m_settings.precision;
    });
  }
  static double halfWidth(const Active& a) {
    const auto means = blockMeans(a.samples, a.software);
    const report::Interval interval = report::medianInterval(means);
    return (interval.high - interval.low) / (2 * std::max(1e-9, report::median(means)));
  }

  void finish(Active& a) {
    // The picture first: it must be of the last timed frame.
    CellResult& result = *a.result;
    result.picture = readPicture(a);
    result.record.picture = contentHashOf(result.picture);
    result.record.stable = result.record.picture == a.untimedPicture;
    result.record.nonfinite = countNonFinite(result.picture);
    for (uint32_t i = 0; i < m_settings.stampedFrames; ++i)
      a.samples.stamped.push_back(a.renderer->frame(FrameMode::Stamped));
    a.samples.counted = a.renderer->frame(FrameMode::Counted);
    summarise(a.samples, a.software, result.record);
    if (halfWidth(a) > m_settings.precision)
      addWarning(a, "stopped by the budget at ±" +
                        std::to_string(int(std::ceil(100 * halfWidth(a)))) + " %, asked for ±" +
                        std::to_string(int(std::lround(100 * m_settings.precision))) + " %");
    for (const rhi::Message& m : a.device->device->takeMessages())
      addWarning(a, "validation: " + m.source + " [" + m.rule + "] " + m.text);
    if (m_devices.validating()) addWarning(a, "contaminated: validation is on");
#ifndef NDEBUG
    addWarning(a, "contaminated: this is a debug build");
#endif
    refuseUnverified(result);
  }

  /// A number whose picture is wrong is worse than none.
  static void refuseUnverified(CellResult& result) {
    report::Record& r = result.record;
    if (*r.nonfinite > 0)
      r.reason = std::to_string(*r.nonfinite) + " values of the picture are not finite";
    else if (!*r.stable)
      r.reason = "the timed run's picture differs from the untimed one";
    if (!r.reason.empty()) r.status = report::Status::Failed;
  }

  void compare() {
    for (Active& a : m_active) {
      if (a.result->record.status != report::Status::Ok) continue;
      for (const Active& b : m_active) {
        if (&a == &b || b.result->record.status != report::Status::Ok) continue;
        const CellId &x = a.result->id, &y = b.result->id;
        const bool baseline = y.technique == "none" && x.backend == y.backend;
        const bool otherBackend = x.technique == y.technique && x.knobs == y.knobs &&
                                  x.transparency == y.transparency && x.backend != y.backend;
        if (otherBackend)
          a.result->record.crossBackendMax255 =
              std::max(a.result->record.crossBackendMax255.value_or(0),
                       maxDifference255(a.result->picture, b.result->picture));
        if (!baseline && !otherBackend) continue;
        const bool software = a.software && b.software;
        report::Ratio ratio = report::pairedRatio(blockMeans(a.samples, software),
                                                  blockMeans(b.samples, software));
        ratio.against = b.result->record.name;
        ratio.of = software ? "cpu_ms" : "frame_ms";
        a.result->record.ratios.push_back(std::move(ratio));
      }
      if (!a.result->record.crossBackendMax255)
        a.result->record.why["cross_backend_max_255"] = "no other backend ran this cell";
    }
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
