// What a run has found so far, kept: its journal, begun or gone on with.
#pragma once

#include <optional>

#include "suites/cli/options/options.h"
#include "suites/harness/devices.h"
#include "suites/harness/group.h"
#include "suites/harness/journal.h"
#include "suites/stability/stability.h"

namespace sb {

/// The journal that --resume names or means. Throws InputError when there is none.
std::filesystem::path journalToResume(const Options& options);

/// With --resume alone: the options of the run that it names. Throws InputError.
Options resolveResume(const Options& given);

/// Everything that decides what a run finds.
JournalHeader describeRun(const Options& options, const MeasureSettings& settings,
                          const std::vector<CellId>& cells, const std::vector<StabilityJob>& jobs,
                          Devices& devices, const report::Run& run);

class Session {
 public:
  /// Throws InputError for a journal of another run, naming what differs.
  Session(const Options& options, const JournalHeader& header);

  Journal& journal() { return *m_journal; }
  /// Of an earlier part of the run; empty in the first.
  const JournalContent& earlier() const { return m_earlier; }
  bool isResumed() const { return m_resumed; }
  /// Everything has been written elsewhere. `pictures`: folder that belongs to the run alone.
  void finish(const std::filesystem::path& pictures);

 private:
  JournalContent m_earlier;
  bool m_resumed = false;
  bool m_ownsFolder = false;  ///< the journal's, within the user's cache
  std::optional<Journal> m_journal;
};

/// Cells that are yet to be measured, as groups: what is finished stands among them as companions
/// where others are compared with it.
std::vector<std::vector<GroupCell>> groupsLeft(const std::vector<std::vector<GroupCell>>& groups,
                                               const JournalContent& earlier);

}  // namespace sb
