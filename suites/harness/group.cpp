#include "suites/harness/group.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <set>

#include "backends/rhi/memory_limit.h"
#include "suites/harness/checks/compare.h"
#include "suites/harness/checks/load_watch.h"
#include "suites/harness/checks/plausible.h"
#include "suites/harness/checks/verify.h"
#include "suites/harness/measuring/active_cell.h"
#include "suites/harness/scene_hash.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

/// Shares of a group's progress at which measuring and verifying begin.
constexpr double kMeasure = 0.3, kVerify = 0.6;

constexpr const char* kNotCompared =
    "the run ended before this cell was compared with the others of its group";

report::Record recordOf(const CellId& id, const std::string& sceneHash, uint32_t seeds,
                        const std::string& version) {
  report::Record r = {.id = recordedId(id),
                      .name = cellName(id),
                      .role = roleOf(id),
                      .sceneHash = sceneHash,
                      .version = version,
                      .command = cellCommand(id, seeds)};
  const Knobs knobs = cellKnobs(id);
  for (const auto& [name, value] : knobs.all()) r.knobs[name] = value;
  return r;
}

/// Cells that are measured together.
class Group {
 public:
  Group(const std::vector<GroupCell>& cells, Devices& devices, const MeasureSettings& settings,
        const std::string& version)
      : m_devices(devices),
        m_settings(settings),
        m_scene(makeScene(cells.front().id.scene)),
        m_stage(m_scene, {cells.front().id.width, cells.front().id.height}),
        m_context{devices, m_stage, settings.checkTimers},
        m_judge(m_scene, sceneHash(m_scene), {cells.front().id.width, cells.front().id.height},
                withProgress(settings.judge)) {
    for (const auto& [id, companion] : cells)
      m_results.push_back(
          {.id = id,
           .companion = companion,
           .record = recordOf(id, m_judge.sceneHash(), settings.judge.seeds, version)});
    m_active.reserve(m_results.size());
  }

  std::vector<CellResult> run() {
    for (size_t i = 0; i < m_results.size() && !interrupted(); ++i) {
      report("prepare", kMeasure * double(i) / double(m_results.size()));
      prepare(m_results[i]);
    }
    // What cannot run is finished; what is measured apart is another group's.
    for (CellResult& r : m_results) r.finished = r.record.status != report::Status::Ok;
    const MachineUse before = machineUse();
    const Stop stop = interrupted() ? Stop::Not : measureBlocks();
    const std::vector<std::string> disturbed = disturbances(before, machineUse());
    for (size_t i = 0; i < m_active.size() && !interrupted(); ++i) {
      m_verified = i;
      report("verify", kVerify + (1 - kVerify) * double(i) / double(m_active.size()));
      ActiveCell& a = m_active[i];
      for (const std::string& d : disturbed) addOnce(a.result().record.contamination, d);
      guarded(a.result(), [&] { finish(a, stop); });
      // What an interruption cut short is no failure either.
      a.result().finished = !interrupted();
      tellVerified(a.result());
    }
    compare();
    std::erase_if(m_results, [&](const CellResult& r) {
      return !r.finished || m_apart.contains(onAnyBackend(r.id));
    });
    return std::move(m_results);
  }

  /// Families of cells that did not fit beside the others.
  const std::set<CellId>& apart() const { return m_apart; }

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

  void skip(CellResult& result, const std::string& why) {
    report::refuse(result.record, why);
    result.record.status = report::Status::Skipped;
  }

  /// A failure of one cell is its record's, not the run's.
  template <class Work>
  void guarded(CellResult& result, const Work& work) {
    if (result.record.status != report::Status::Ok) return;
    if (const std::string lost = m_devices.whyLost(result.id.backend); !lost.empty())
      return report::refuse(result.record, lost);
    try {
      work();
    } catch (const rhi::Error& e) {
      if (rhi::isTooLarge(e)) return skip(result, rhi::whyTooLarge(e));
      if (rhi::isDeviceLost(e)) m_devices.lose(result.id.backend, e.what());
      report::refuse(result.record, e.what());
    } catch (const std::bad_alloc&) {
      skip(result, std::string(rhi::kTooLargeWords) + "the machine's memory does not hold it");
    } catch (const std::exception& e) {
      report::refuse(result.record, e.what());
    }
  }

  void prepare(CellResult& result) {
    if (m_apart.contains(onAnyBackend(result.id))) return;
    guarded(result, [&] {
      auto subject = makeSubject(result.id, m_context, result.record);
      if (subject) m_active.emplace_back(result, std::move(subject), m_settings);
    });
    const bool tooLarge = result.record.status == report::Status::Skipped &&
                          result.record.reason.starts_with(rhi::kTooLargeWords);
    // Beside nothing it is too large at all; a companion is not worth a group.
    if (!tooLarge || m_active.empty() || result.companion) return;
    const CellId family = onAnyBackend(result.id);
    m_apart.insert(family);
    std::erase_if(m_active, [&](ActiveCell& a) { return onAnyBackend(a.result().id) == family; });
  }

  bool isOver(const ActiveCell& a) const { return !a.ok() || a.isSpent(); }

  /// Rounds of a block each; of cells that an earlier part of the run left behind, those first.
  Stop measureBlocks() {
    while (true) {
      size_t round = SIZE_MAX;
      for (const ActiveCell& a : m_active)
        if (!isOver(a)) round = std::min(round, a.samples().blocks.size());
      if (const Stop stop = stopAfter(round); stop != Stop::Not || round == SIZE_MAX) return stop;
      for (size_t i : roundOrder(m_active.size(), uint32_t(round))) {
        ActiveCell& a = m_active[i];
        if (isOver(a) || a.samples().blocks.size() > round) continue;
        guarded(a.result(), [&] { a.measureBlock(); });
        if (interrupted()) return Stop::Not;
      }
    }
  }

  /// Whether `rounds` are enough. Cells that are slow keep to their own budget, and nobody waits
  /// for their precision.
  Stop stopAfter(size_t rounds) {
    std::vector<double> widths;
    double seconds = 0;
    for (const ActiveCell& a : m_active) {
      if (!a.ok() || a.isSlow()) continue;
      widths.push_back(relativeHalfWidth(blockMeans(a.samples(), a.software())));
      seconds += a.secondsInBlocks();
    }
    if (rounds == SIZE_MAX) return Stop::Budget;
    if (widths.empty() || rounds == 0) return Stop::Not;
    const double spent = seconds / std::max(1e-9, m_settings.budgetSeconds * double(widths.size()));
    report("measure", kMeasure + (kVerify - kMeasure) * std::min(1.0, spent));
    return stopNow(m_settings.stop, uint32_t(rounds), spent, widths);
  }

  void finish(ActiveCell& a, Stop stop) {
    CellResult& result = a.result();
    report::Record& record = result.record;
    a.finish(stop);
    if (m_devices.validating()) addOnce(record.contamination, "validation is on");
#ifndef NDEBUG
    addOnce(record.contamination, "this is a debug build");
#endif
    for (const std::string& w : a.subject().warnings()) addOnce(record.warnings, w);
    for (const auto& [name, count] : a.subject().counts()) record.counts[name] = count;
    if (isUniform(result.picture)) addOnce(record.warnings, "the picture has a single colour");
    for (const std::string& why : {whyRefused(record), whyImplausible(a.samples(), a.software())})
      if (!why.empty()) return report::refuse(record, why);
    // Nobody asks how wrong a companion is.
    if (!result.companion)
      m_judge.judge(a.subject(), result.id, result.picture, record, result.files);
  }

  void tellVerified(const CellResult& result) {
    if (!m_settings.onVerified || !result.finished || result.companion) return;
    CellResult alone{
        .id = result.id, .record = result.record, .files = result.files, .finished = true};
    if (alone.record.status == report::Status::Ok)
      for (const char* key : {"ratios", "cross_backend_max_255", "cross_backend_over_1_255"})
        alone.record.why[key] = kNotCompared;
    m_settings.onVerified(alone);
  }

  void compare() {
    std::vector<Measured> measured;
    for (ActiveCell& a : m_active)
      if (a.result().finished) measured.push_back({&a.result(), &a.samples(), a.software()});
    compareCells(measured);
    // An interval of a ratio needs as many pairs as one of a median.
    for (ActiveCell& a : m_active) {
      report::Record& record = a.result().record;
      const size_t removed = std::erase_if(record.ratios, [&](const report::Ratio& r) {
        return m_settings.stop.repetitions == 0 && r.n < m_settings.stop.minBlocks;
      });
      if (removed > 0 && record.ratios.empty())
        record.why["ratios"] = "the budget allowed fewer than " +
                               std::to_string(m_settings.stop.minBlocks) + " pairs of blocks";
    }
  }

  Devices& m_devices;
  const MeasureSettings& m_settings;
  const Scene m_scene;
  Stage m_stage;
  SubjectContext m_context;
  Judge m_judge;
  std::vector<CellResult> m_results;
  std::vector<ActiveCell> m_active;
  std::set<CellId> m_apart;
  size_t m_verified = 0;  ///< cells
};

/// Groups for what did not fit: all of it with baselines, or, where that was tried, each family
/// alone, and then each cell.
std::vector<std::vector<GroupCell>> smallerGroups(const std::vector<GroupCell>& cells,
                                                  const std::set<CellId>& apart) {
  std::vector<CellId> left;
  size_t asked = 0;
  for (const auto& [id, companion] : cells) {
    asked += !companion;
    if (!companion && apart.contains(onAnyBackend(id))) left.push_back(id);
  }
  const bool stuck = left.size() == asked;
  std::map<CellId, std::vector<GroupCell>> parts;
  for (const CellId& id : left)
    parts[!stuck ? CellId{} : apart.size() > 1 ? onAnyBackend(id) : id].push_back(id);
  std::vector<std::vector<GroupCell>> groups;
  for (auto& [key, part] : parts) {
    addBaselines(part);
    groups.push_back(std::move(part));
  }
  return groups;
}

}  // namespace

std::vector<CellResult> measureGroup(const std::vector<GroupCell>& cells, Devices& devices,
                                     const MeasureSettings& settings, const std::string& version) {
  std::vector<CellResult> results;
  std::vector<std::vector<GroupCell>> pending = {cells};
  const auto isInterrupted = [&] { return settings.interrupted && settings.interrupted->load(); };
  for (bool first = true; !pending.empty() && (first || !isInterrupted()); first = false) {
    const std::vector<GroupCell> part = std::move(pending.front());
    pending.erase(pending.begin());
    std::set<CellId> apart;
    {
      Group group(part, devices, settings, version);
      for (CellResult& r : group.run()) {
        if (!first && !r.companion)
          addOnce(r.record.warnings,
                  "measured after the others of its group: together they do not fit the memory");
        if (first || !r.companion) results.push_back(std::move(r));
      }
      apart = group.apart();
    }
    if (apart.empty()) continue;
    const auto smaller = smallerGroups(part, apart);
    pending.insert(pending.begin(), smaller.begin(), smaller.end());
  }
  // In the order of the cells, wherever they were measured.
  std::map<CellId, size_t> order;
  for (const GroupCell& cell : cells) order.try_emplace(cell.id, order.size());
  std::ranges::stable_sort(results, {}, [&](const CellResult& r) { return order.at(r.id); });
  return results;
}

}  // namespace sb
