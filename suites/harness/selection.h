// From what the user asks for to the list of cells, and to groups of cells that are compared.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "suites/harness/cell.h"

namespace sb {

/// As it stands on the command line; empty means "the default".
struct Selection {
  std::vector<std::string> techniques;  ///< "CSSM2" or "CSSM2+Sorted"; default: all
  std::vector<std::string> backends;    ///< default: those of `defaultBackends`
  std::vector<std::string> scenes;  ///< NAME[:param=value,...] or a file; default: the quick four
  std::vector<std::string> sets;    ///< "knob=v1,v2": a sweep
  std::vector<std::string> edits;   ///< of every scene, see suites/scenes/scene_edit.h
  std::string filter;               ///< ECMAScript regular expression over names
  bool filterExcludes = false;      ///< the filter names what is left out
  std::optional<std::pair<uint32_t, uint32_t>> size;
  uint32_t seed = 0;
};

/// Scenes of the quick suite.
const std::vector<std::string>& quickScenes();

/// All cells of the selection, names unique, in a fixed order. Throws InputError naming the nearest
/// existing technique, knob or backend, or when the filter matches nothing or is no regular
/// expression.
std::vector<CellId> selectCells(const Selection& selection,
                                const std::vector<std::string>& knownBackends,
                                const std::vector<std::string>& defaultBackends);

/// The cells that a filter leaves. Throws InputError like selectCells.
std::vector<CellId> filterCells(const Selection& selection, const std::vector<CellId>& cells);

/// Cells that run interleaved: same scene, size and seed. At most `most` asked-for cells in a
/// group, a cell's backends always together; baselines that are not asked for are added as
/// companions.
std::vector<std::vector<CellId>> groupCells(const std::vector<CellId>& cells, size_t most = 16);

}  // namespace sb
