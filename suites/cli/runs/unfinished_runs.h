// Journals of runs that ended early and had no JSON file to lie beside: in the user's cache, until
// they are resumed or cleared.
#pragma once

#include <cstdint>
#include <filesystem>

namespace sb {

/// $XDG_CACHE_HOME/shadowbench/runs, or as truthCacheFolder() has it.
std::filesystem::path unfinishedRunsFolder();

struct UnfinishedRuns {
  uint64_t ended = 0;     ///< early
  uint64_t underWay = 0;  ///< a process still writes them
};
UnfinishedRuns unfinishedRuns();
/// Removes those that ended, and what this program wrote beside their journals; nothing else.
UnfinishedRuns clearUnfinishedRuns();

}  // namespace sb
