#include "suites/cli/runs/session.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "base/atomic_file.h"
#include "base/number.h"
#include "base/text.h"
#include "reports/html/html.h"
#include "reports/picture.h"
#include "suites/cli/runs/unfinished_runs.h"
#include "suites/cli/say.h"
#include "suites/cli/vector_width.h"
#include "suites/harness/scene_hash.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

namespace fs = std::filesystem;

bool keepsJson(const Options& o) {
  return !o.files.json.empty() && !base::isSpecialFile(o.files.json);
}

/// Of runs without a JSON file to lie beside.
fs::path ownFolder(const report::Run& run) {
  std::string stamp = run.date.substr(0, 19);
  std::erase(stamp, ':');
  return unfinishedRunsFolder() / (stamp + "-" + std::to_string(getpid()));
}

/// A journal that holds something is somebody's results.
void setAside(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return;
  if (isJournalInUse(path))
    throw InputError("journal", "another run writes " + path.string() + " now");
  // A run that was killed before it wrote its first line.
  if (fs::is_regular_file(path, error) && fs::file_size(path, error) == 0) return;
  try {
    const JournalContent content = readJournal(path);
    if (content.cells.empty() && content.hardCases.empty() && content.blocks.empty()) return;
  } catch (const InputError&) {
    throw InputError("journal", "found " + path.string() +
                                    ", which is no journal of a run, expected its place free");
  }
  fs::path old = path;
  for (int n = 1; n == 1 || fs::exists(fs::symlink_status(old, error)); ++n)
    old = path.string() + ".old" + (n > 1 ? std::to_string(n) : "");
  fs::rename(path, old, error);
  if (error) throw InputError("journal", "cannot move " + path.string() + ": " + error.message());
  say("found the journal of a run that ended early; it is " + old.string() + " now (--resume)");
}

}  // namespace

fs::path journalToResume(const Options& options) {
  if (options.resume.file.empty() && !keepsJson(options))
    throw InputError("--resume", "found neither a file nor --json, expected a journal or results");
  const fs::path named = options.resume.file.empty() ? options.files.json : options.resume.file;
  std::error_code error;
  if (named.extension() != ".json" && fs::is_regular_file(named, error)) return named;
  const fs::path beside = report::journalBeside(named);
  if (!fs::is_regular_file(beside, error))
    throw InputError("--resume", "found no journal " + beside.string() +
                                     ": that run is complete, or there was none");
  return beside;
}

Options resolveResume(const Options& given) {
  if (!given.resume.wanted) return given;
  // Everything but the option itself, its file and --quiet is a run of its own.
  const bool alone = std::ranges::all_of(given.arguments, [&](const std::string& a) {
    return a.starts_with("--resume") || a == "--quiet" || a == given.resume.file;
  });
  if (!alone) return given;
  const JournalHeader header = readJournal(journalToResume(given)).header;
  if (const std::string here = fs::current_path().string(); here != header.folder)
    throw InputError("--resume", "the run was started in " + header.folder + ", found " + here +
                                     ", expected the same folder (or all of its arguments)");
  auto options = parseOptions(header.arguments);
  if (!options) throw InputError("--resume", "the journal names no run that measures");
  options->arguments = header.arguments;
  options->resume.wanted = true;
  options->resume.file = fs::absolute(journalToResume(given)).string();
  options->quiet |= given.quiet;
  return *options;
}

/// Of a folder's shaders and what they hold: they may be changed between two parts of a run.
static std::string folderIdentity(const fs::path& folder) {
  std::map<std::string, std::string> files;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    const fs::path extension = entry->path().extension();
    if (!entry->is_regular_file(ignored) || (extension != ".glsl" && extension != ".h")) continue;
    std::ifstream in(entry->path(), std::ios::binary);
    files[entry->path().string()] = std::string(std::istreambuf_iterator<char>(in), {});
  }
  std::string all;
  for (const auto& [name, content] : files)
    all += name + '\0' + std::to_string(content.size()) + '\0' + content;
  return folder.string() + " " + report::contentHash(std::as_bytes(std::span(all)));
}

JournalHeader describeRun(const Options& options, const MeasureSettings& settings,
                          const std::vector<CellId>& cells, const std::vector<StabilityJob>& jobs,
                          Devices& devices, const report::Run& run) {
  JournalHeader h{.arguments = options.arguments,
                  .folder = fs::current_path().string(),
                  .program = run.version + " " + run.commit + " " + run.buildType};
  h.settings = {
      {"budget", base::numberText(settings.budgetSeconds)},
      {"precision", base::numberText(settings.stop.precision)},
      {"repetitions", std::to_string(settings.stop.repetitions)},
      {"seeds", std::to_string(settings.judge.seeds)},
      {"truth", settings.judge.enabled ? "yes" : "no"},
      {"exposure",
       settings.judge.exposure ? base::numberText(double(*settings.judge.exposure)) : "automatic"},
      {"validation", options.device.validate ? "yes" : "no"},
      {"shaders", options.device.shaderFolder.empty()
                      ? "built-in"
                      : folderIdentity(options.device.shaderFolder)}};
  if (const std::string width = vectorWidth(); !width.empty()) h.settings["vector width"] = width;
  std::set<std::string> backends;
  for (const CellId& cell : cells) {
    h.cells.push_back(cellName(cell));
    if (!isReference(cell)) backends.insert(cell.backend);
    const std::string scene = base::printable(cell.scene);
    if (!h.scenes.contains(scene)) h.scenes[scene] = sceneHash(makeScene(cell.scene));
  }
  for (const StabilityJob& job : jobs) {
    h.hardCases.push_back(jobName(job));
    h.settings["points of hard cases"] = job.quick ? "few" : "all";
    h.settings["seeds of hard cases"] = std::to_string(job.seeds);
    backends.insert(job.backend);
    if (const std::string scene = base::printable(job.scene);
        !scene.empty() && !h.scenes.contains(scene))
      h.scenes[scene] = sceneHash(makeScene(job.scene));
  }
  for (const std::string& backend : backends) {
    const DeviceSession* session = devices.open(backend);
    h.devices[backend] = session ? session->device->info().name + ", " +
                                       session->device->info().driver + " " +
                                       session->device->info().driverVersion
                                 : "no device";
  }
  return h;
}

Session::Session(const Options& options, const JournalHeader& header)
    : m_resumed(options.resume.wanted) {
  if (options.resume.wanted) {
    const fs::path path = journalToResume(options);
    m_earlier = readJournal(path);
    const auto different = differences(m_earlier.header, header);
    if (!different.empty())
      throw InputError("--resume", path.string() + " is of another run: " + different.front() +
                                       (different.size() > 1
                                            ? "; and " + std::to_string(different.size() - 1) +
                                                  " more differences"
                                            : ""));
    if (m_earlier.halfLine) say("the journal's last line was cut off: what it held is done again");
    m_journal.emplace(path, m_earlier);
    m_ownsFolder = path.filename() == "run.journal";
    return;
  }
  fs::path path;
  if (keepsJson(options)) {
    path = report::journalBeside(options.files.json);
    setAside(path);
  } else {
    const fs::path folder = ownFolder(report::describeMachine("bench", ""));
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
      throw InputError("journal", "cannot make " + folder.string() + ": " + error.message());
    path = folder / "run.journal";
    m_ownsFolder = true;
  }
  m_journal.emplace(path, header);
}

void Session::finish(const fs::path& pictures) {
  m_journal->remove();
  if (!m_ownsFolder) return;
  std::error_code ignored;
  if (!pictures.empty() && pictures.parent_path() == m_journal->path().parent_path())
    fs::remove_all(pictures, ignored);
  fs::remove(m_journal->path().parent_path(), ignored);
}

std::vector<std::vector<GroupCell>> groupsLeft(const std::vector<std::vector<GroupCell>>& groups,
                                               const JournalContent& earlier) {
  const auto isDone = [&](const CellId& id) { return earlier.cells.contains(recordedId(id)); };
  std::vector<std::vector<GroupCell>> left;
  for (const std::vector<GroupCell>& group : groups) {
    std::set<CellId> compared;
    for (const auto& [id, companion] : group) {
      if (companion || isDone(id)) continue;
      if (!isReference(id)) compared.insert(baselineOf(id));
      for (const GroupCell& other : group) {
        // The tracer is told against whatever has no shadows.
        const bool isBaseline = isReference(id) && roleOf(other.id) == report::Role::Baseline;
        // The same cell elsewhere.
        if (isBaseline || onAnyBackend(other.id) == onAnyBackend(id)) compared.insert(other.id);
      }
    }
    std::vector<GroupCell> rest;
    for (const auto& [id, companion] : group) {
      const bool done = isDone(id);
      if ((done || companion) && !compared.contains(id)) continue;
      rest.emplace_back(id, companion || done);
    }
    if (std::ranges::any_of(rest, [](const GroupCell& c) { return !c.companion; }))
      left.push_back(std::move(rest));
  }
  return left;
}

}  // namespace sb
