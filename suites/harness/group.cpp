#include "suites/harness/group.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "backends/rhi/memory_limit.h"
#include "reports/stats/stats.h"
#include "suites/harness/compare.h"
#include "suites/harness/judge.h"
#include "suites/harness/load_watch.h"
#include "suites/harness/plausible.h"
#include "suites/harness/scene_hash.h"
#include "suites/harness/subject.h"
#include "suites/harness/verify.h"
#include "suites/scenes/analysis.h"
#include "suites/scenes/procedural.h"

namespace sb {
namespace {

using Clock = std::chrono::steady_clock;

/// Shares of a group's progress at which measuring and verifying begin.
constexpr double kMeasure = 0.3, kVerify = 0.6;

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
  return r;
}

/// A cell under measurement.
struct Active {
  CellResult* result = nullptr;
  std::unique_ptr<Subject> subject;
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
      : m_devices(devices),
        m_settings(settings),
        m_scene(makeScene(cells.front().scene)),
        m_effects(analyse(m_scene, double(cells.front().width) / double(cells.front().height))),
        m_context{devices, m_scene, m_effects, settings.checkTimers, {}},
        m_judge(m_scene, sceneHash(m_scene), {cells.front().width, cells.front().height},
                withProgress(settings.judge)) {
    for (const CellId& id : cells)
      m_results.push_back({id, recordOf(id, m_judge.sceneHash(), version), {}, {}});
    m_active.reserve(m_results.size());
  }

  std::vector<CellResult> run() {
    for (size_t i = 0; i < m_results.size(); ++i) {
      report("prepare", kMeasure * double(i) / double(m_results.size()));
      guarded(m_results[i], [&] { prepare(m_results[i]); });
      if (interrupted()) return {};
    }
    const MachineUse before = machineUse();
    const Stop stop = measureBlocks();
    if (interrupted()) return {};
    const std::vector<std::string> disturbed = disturbances(before, machineUse());
    for (size_t i = 0; i < m_active.size(); ++i) {
      m_verified = i;
      report("verify", kVerify + (1 - kVerify) * double(i) / double(m_active.size()));
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
  JudgeSettings withProgress(JudgeSettings judge) {
    judge.progress = [this](double done) {
      report("verify", kVerify + (1 - kVerify) * (double(m_verified) + done) /
                                     double(std::max<size_t>(1, m_active.size())));
    };
    return judge;
  }

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
      report::refuse(result.record, rhi::isTooLarge(e) ? rhi::whyTooLarge(e) : e.what());
      if (rhi::isTooLarge(e)) result.record.status = report::Status::Skipped;
    } catch (const std::exception& e) {
      report::refuse(result.record, e.what());
    }
  }

  void prepare(CellResult& result) {
    Active a;
    a.result = &result;
    a.subject = makeSubject(result.id, m_context, result.record);
    if (!a.subject) return;
    a.software = a.subject->software();
    a.samples.passesUntrusted = a.subject->passesUntrusted();
    a.subject->describe(result.record);
    warmUp(a);
    a.untimedPicture = contentHashOf(a.subject->picture());
    takeMessages(a);
    m_active.push_back(std::move(a));
  }

  /// One frame, or one loop of a camera in motion, which then stands at the end of its path again.
  /// Its wall time.
  static double loopMs(Subject& subject, FrameMode mode) {
    double wall = 0;
    for (uint32_t i = 0; i < subject.steps(); ++i) wall += subject.frame(mode).wallMs;
    return wall;
  }

  static std::vector<FrameResult> frames(Subject& subject, FrameMode mode, uint32_t count) {
    std::vector<FrameResult> frames;
    for (uint32_t i = 0; i < count; ++i) frames.push_back(subject.frame(mode));
    return frames;
  }

  /// Every pipeline and state is drawn twice before the windows begin.
  void warmUp(Active& a) {
    Subject& subject = *a.subject;
    a.samples.loop = subject.steps();
    const double first = loopMs(subject, FrameMode::Plain);
    const uint32_t windowFrames =
        wholeLoops(subject.hasPasses() ? WarmUp::kWindowFrames : 1, subject.steps());
    if (subject.hasPasses()) {
      loopMs(subject, FrameMode::Stamped);
      loopMs(subject, FrameMode::Counted);
    }
    WarmUp rule;
    for (bool done = false; !done && !interrupted();) {
      std::vector<double> times;
      for (uint32_t i = 0; i < windowFrames; ++i)
        times.push_back(rankingMs(subject.frame(FrameMode::Plain), a.software));
      done = rule.add(report::median(times));
    }
    if (!rule.steady())
      a.result->record.warnings.push_back("ten warm-up windows did not agree: the time drifts");
    const double warm = loopMs(subject, FrameMode::Plain);
    a.samples.compileMs = subject.createMs() + std::max(0.0, first - warm);
    const double frame = std::max(warm / double(subject.steps()), 1e-3);
    a.framesPerBlock =
        wholeLoops(uint32_t(std::clamp(m_settings.blockSeconds * 1e3 / frame, 1.0, 32.0)),
                   subject.steps());
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
      report("measure", kMeasure + (kVerify - kMeasure) * std::min(1.0, spent));
      std::vector<double> widths;
      for (const Active& a : m_active)
        if (a.ok()) widths.push_back(relativeHalfWidth(blockMeans(a.samples, a.software)));
      const Stop stop = stopNow(m_settings.stop, round + 1, spent, widths);
      if (stop != Stop::Not || interrupted()) return stop;
    }
    return Stop::Not;
  }

  void measureBlock(Active& a) {
    const size_t pipelines = a.subject->pipelines();
    // A counter that is reset spoils one block, a broken one all.
    for (int attempt = 0; attempt < 3; ++attempt)
      if (addBlock(a.samples, frames(*a.subject, FrameMode::Plain, a.framesPerBlock), a.software))
        break;
      else if (attempt == 2)
        throw std::runtime_error("timer not trusted: the stamps of every frame exceed its wall time");
    if (a.subject->pipelines() != pipelines)
      addOnce(a.result->record.contamination, "a pipeline was created within a timed frame");
    takeMessages(a);
  }

  /// What a device's validation said since the last call belongs to the cell that ran.
  static void takeMessages(Active& a) {
    for (const rhi::Message& m : a.subject->takeMessages())
      addOnce(a.result->record.warnings, "validation: " + m.source + " [" + m.rule + "] " + m.text);
  }

  void finish(Active& a, Stop stop) {
    CellResult& result = *a.result;
    report::Record& record = result.record;
    // The picture first: it must be of the last timed frame.
    result.picture = a.subject->picture();
    record.picture = contentHashOf(result.picture);
    record.stable = record.picture == a.untimedPicture;
    record.nonfinite = countNonFinite(result.picture);
    if (a.subject->hasPasses()) {
      const uint32_t steps = a.subject->steps();
      for (uint32_t i = 0; i < m_settings.stampedFrames; i += steps) {
        std::vector<FrameResult> stamped = frames(*a.subject, FrameMode::Stamped, steps);
        addStamped(a.samples, {std::move(stamped), frames(*a.subject, FrameMode::Plain, steps)});
      }
      for (uint32_t i = 0; i < a.subject->steps(); ++i)
        a.samples.counted = a.subject->frame(FrameMode::Counted);
    }
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
    if (Renderer* renderer = a.subject->renderer())
      for (const std::string& w : renderer->warnings()) addOnce(record.warnings, w);
    if (isUniform(result.picture)) addOnce(record.warnings, "the picture has a single colour");
    for (const std::string& why : {whyRefused(record), whyImplausible(a.samples, a.software)})
      if (!why.empty()) return report::refuse(record, why);
    m_judge.judge(*a.subject, result.id, result.picture, record, result.files);
  }

  Devices& m_devices;
  const MeasureSettings& m_settings;
  const Scene m_scene;
  const Effects m_effects;
  SubjectContext m_context;
  Judge m_judge;
  std::vector<CellResult> m_results;
  std::vector<Active> m_active;
  size_t m_verified = 0;  ///< cells
};

}  // namespace

std::vector<CellResult> measureGroup(const std::vector<CellId>& cells, Devices& devices,
                                     const MeasureSettings& settings, const std::string& version) {
  return Group(cells, devices, settings, version).run();
}

}  // namespace sb
