// From what the user asks for to the list of cells, and to groups of cells that are compared.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/pattern.h"
#include "suites/harness/cell.h"

namespace sb {

/// Most cells of a selection.
inline constexpr size_t kMostCells = 100000;

/// As it stands on the command line; empty means "the default".
struct Selection {
  std::vector<std::string> techniques;  ///< TECHNIQUE[+TRANSPARENCY][@LIGHTS]; default: all
  std::vector<std::string> backends;    ///< default: those of `defaultBackends`
  std::vector<std::string> scenes;  ///< NAME[:param=value,...] or a file; default: the quick four
  std::vector<std::string> sets;    ///< "knob=v1,v2": a sweep
  std::vector<std::string> edits;   ///< of every scene, see suites/scenes/edit/scene_edit.h
  std::string filter;               ///< regular expression over names
  bool filterExcludes = false;      ///< the filter names what is left out
  std::optional<std::pair<uint32_t, uint32_t>> size;
  uint32_t seed = 0;
};

/// Scenes of the quick suite.
const std::vector<std::string>& quickScenes();

/// The scenes that are named, with all edits, in canonical form. Throws InputError.
std::vector<std::string> namedScenes(const Selection& selection);

/// Throws InputError unless all are backends of the program, or the tracer's.
void requireKnownBackends(const std::vector<std::string>& backends,
                          std::vector<std::string> known);

/// All cells of the selection, names unique, in a fixed order. Throws InputError naming the nearest
/// existing technique, knob or backend, or when the filter matches nothing or is no regular
/// expression.
std::vector<CellId> selectCells(const Selection& selection,
                                const std::vector<std::string>& knownBackends,
                                const std::vector<std::string>& defaultBackends);

/// Of names of cells and hard cases. Throws InputError naming --filter.
base::Pattern parseFilter(const std::string& filter);

/// What --filter leaves of names: the one that it is, where there is one; else those that hold it
/// as it stands, and those in which it is found as a regular expression. So a name that was printed
/// always finds itself, whatever its '+', '?' or '*' mean in an expression.
class NameFilter {
 public:
  /// Throws InputError when nothing of `names` is left (with the nearest), or when the filter is
  /// neither a part of a name nor a regular expression.
  NameFilter(const Selection& selection, const std::vector<std::string>& names);
  bool keeps(const std::string& name) const { return m_all || m_kept.contains(name); }

 private:
  bool m_all = false;
  std::set<std::string> m_kept;
};

/// The cells that a filter leaves. Throws InputError like selectCells.
std::vector<CellId> filterCells(const Selection& selection, const std::vector<CellId>& cells);

/// A cell among those that it is compared with.
struct GroupCell {
  GroupCell(CellId cell, bool isCompanion = false) : id(std::move(cell)), companion(isCompanion) {}
  CellId id;
  bool companion;  ///< measured for comparison only: not asked for, not reported
};

/// Adds to a group, as companions, the baselines that it lacks.
void addBaselines(std::vector<GroupCell>& group);

/// Cells that run interleaved: same scene, size and seed. At most `most` asked-for cells in a
/// group, a cell's backends always together; baselines that are not asked for are added as
/// companions.
std::vector<std::vector<GroupCell>> groupCells(const std::vector<CellId>& cells, size_t most = 16);

}  // namespace sb
