#include "suites/cli/runs/unfinished_runs.h"

#include "reports/html/html.h"
#include "suites/harness/journal.h"
#include "suites/truth/truth_cache.h"

namespace sb {
namespace {

namespace fs = std::filesystem;

template <class Action>
UnfinishedRuns forEachRun(const Action& ended) {
  UnfinishedRuns runs;
  std::error_code error;
  for (fs::directory_iterator run(unfinishedRunsFolder(), error), end; !error && run != end;
       run.increment(error)) {
    const fs::path journal = run->path() / "run.journal";
    std::error_code ignored;
    if (!fs::is_regular_file(journal, ignored)) continue;
    if (isJournalInUse(journal)) {
      ++runs.underWay;
      continue;
    }
    ++runs.ended;
    ended(journal);
  }
  return runs;
}

}  // namespace

fs::path unfinishedRunsFolder() { return truthCacheFolder().parent_path() / "runs"; }

UnfinishedRuns unfinishedRuns() {
  return forEachRun([](const fs::path&) {});
}

UnfinishedRuns clearUnfinishedRuns() {
  return forEachRun([](const fs::path& journal) {
    std::error_code ignored;
    fs::remove_all(report::picturesBeside(journal), ignored);
    fs::remove(journal, ignored);
    fs::remove(journal.parent_path(), ignored);  // only when nothing else lies there
  });
}

}  // namespace sb
