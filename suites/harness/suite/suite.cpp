#include "suites/harness/suite/suite.h"

#include <toml++/toml.h>

#include <set>
#include <sstream>

#include "base/number.h"
#include "reports/bounded_file.h"
#include "suites/harness/suite/builtin_suites.h"
#include "suites/harness/suite/suite_reader.h"
#include "suites/scenes/edit/scene_edit.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

std::pair<uint32_t, uint32_t> sizeOf(const SuiteReader& reader, const toml::node& node,
                                     const std::string& field) {
  const auto size = base::readSize(reader.text(node, field));
  if (!size) reader.fail(node, field, base::kSizeForm);
  return *size;
}

/// Changes of the run's scenes, as the options --camera, --sun and --set-material give them.
std::vector<std::string> editsOf(const SuiteReader& reader, const toml::table& run,
                                 const std::string& field) {
  std::vector<std::string> edits;
  auto add = [&](const toml::node& node, const char* key, const std::string& edit) {
    try {
      parseEdits(edit);
    } catch (const InputError& e) {
      throw InputError(reader.at(node) + ": " + field + "." + key, e.what());
    }
    edits.push_back(edit);
  };
  for (const char* key : {"camera", "sun", "motion"})
    if (const auto* n = run.get(key))
      add(*n, key, std::string(key) + ":" + reader.text(*n, field + "." + key));
  if (const auto* n = run.get("materials"))
    for (const std::string& edit : reader.texts(*n, field + ".materials"))
      add(*n, "materials", edit);
  return edits;
}

SuiteRun parseRun(const SuiteReader& reader, const toml::node& node, size_t index) {
  const std::string field = "run " + std::to_string(index + 1);
  const toml::table* table = &reader.table(node, field);
  reader.requireKnown(*table, field,
                      {"scenes", "techniques", "backends", "size", "set", "grid", "sweep", "camera",
                       "sun", "materials", "motion"});
  Selection base;
  base.scenes = reader.texts(reader.need(*table, field, "scenes"), field + ".scenes");
  if (const auto* n = table->get("techniques"))
    base.techniques = reader.texts(*n, field + ".techniques");
  if (const auto* n = table->get("backends")) base.backends = reader.texts(*n, field + ".backends");
  if (const auto* n = table->get("size")) base.size = sizeOf(reader, *n, field + ".size");
  base.edits = editsOf(reader, *table, field);
  base.sets = reader.sets(*table, "set", field, false);
  const SuiteReader::Texts grid = reader.sets(*table, "grid", field, true);
  base.sets.insert(base.sets.end(), grid.begin(), grid.end());
  SuiteRun run{.where = reader.at(node) + ": " + field, .selections = {base}};
  for (const std::string& sweep : reader.sets(*table, "sweep", field, true)) {
    Selection swept = base;
    swept.sets.push_back(sweep);
    run.selections.push_back(std::move(swept));
  }
  return run;
}

/// One set of knobs for each value of each entry of `sweep`, or one alone, all with those of `set`.
std::vector<std::map<std::string, std::string>> variants(const SuiteReader& reader,
                                                         const toml::table& run,
                                                         const std::string& field) {
  std::map<std::string, std::string> fixed;
  for (const std::string& text : reader.sets(run, "set", field, false))
    fixed[text.substr(0, text.find('='))] = text.substr(text.find('=') + 1);
  std::vector<std::map<std::string, std::string>> all;
  for (const std::string& text : reader.sets(run, "sweep", field, true)) {
    std::stringstream list(text.substr(text.find('=') + 1));
    for (std::string value; std::getline(list, value, ',');) {
      all.push_back(fixed);
      all.back()[text.substr(0, text.find('='))] = value;
    }
  }
  if (all.empty()) all.push_back(fixed);
  return all;
}

StabilityRun parseStability(const SuiteReader& reader, const toml::node& node, size_t index) {
  const std::string field = "stability " + std::to_string(index + 1);
  const toml::table* table = &reader.table(node, field);
  reader.requireKnown(*table, field, {"cases", "techniques", "set", "sweep", "seeds", "quick"});
  StabilityRun run{.where = reader.at(node) + ": " + field};
  run.variants = variants(reader, *table, field);
  if (const auto* n = table->get("seeds"))
    run.seeds = uint32_t(reader.number(*n, field + ".seeds", kSeedCount));
  if (const auto* n = table->get("quick")) run.quick = reader.boolean(*n, field + ".quick");
  if (const auto* n = table->get("cases")) run.cases = reader.texts(*n, field + ".cases");
  if (const auto* n = table->get("techniques"))
    run.techniques = reader.texts(*n, field + ".techniques");
  return run;
}

std::vector<CellId> cellsOf(const Selection& selection, const std::vector<std::string>& known,
                            const std::vector<std::string>& defaults, const std::string& where) {
  try {
    return selectCells(selection, known, defaults);
  } catch (const InputError& e) {
    throw InputError(where, e.what());
  }
}

}  // namespace

std::vector<std::string> builtinSuites() {
  std::vector<std::string> names;
  for (const auto& [name, text] : kBuiltinSuites) names.emplace_back(name);
  return names;
}

/// The parser follows the parts of a key by recursion, and counts those of arrays alone.
static void requireShallow(std::string_view text, const std::string& file) {
  constexpr size_t kMostDots = 1000;
  size_t line = 1, dots = 0;
  for (const char c : text) {
    if (c == '\n') ++line, dots = 0;
    if (c == '.' && ++dots > kMostDots)
      throw InputError(file + ":" + std::to_string(line),
                       "found a line of more than " + std::to_string(kMostDots) +
                           " dots, expected keys of a few parts");
  }
}

Suite parseSuite(std::string_view text, const std::string& file) {
  const SuiteReader reader(file);
  requireShallow(text, file);
  toml::table root;
  try {
    root = toml::parse(text, file);
  } catch (const toml::parse_error& e) {
    throw InputError(file + ":" + std::to_string(e.source().begin.line),
                     std::string(e.description()));
  }
  reader.requireKnown(root, "",
                      {"title", "seeds", "budget", "precision", "run", "stability", "figure"});
  Suite suite{.name = file};
  if (const auto* n = root.get("title")) suite.title = reader.text(*n, "title");
  if (const auto* n = root.get("seeds")) suite.seeds = uint32_t(reader.number(*n, "seeds", kSeedCount));
  if (const auto* n = root.get("budget")) suite.budgetSeconds = reader.number(*n, "budget", kBudgetSeconds);
  if (const auto* n = root.get("precision"))
    suite.precisionPercent = reader.number(*n, "precision", kPrecisionPercent);
  if (!root.get("run") && !root.get("stability"))
    throw InputError(file, "has no [[run]] and no [[stability]]");
  reader.eachTable(root, "", "run", [&](const toml::node& node, size_t i) {
    suite.runs.push_back(parseRun(reader, node, i));
  });
  reader.eachTable(root, "", "stability", [&](const toml::node& node, size_t i) {
    suite.stability.push_back(parseStability(reader, node, i));
  });
  reader.eachTable(root, "", "figure", [&](const toml::node& node, size_t i) {
    suite.figures.push_back(parseFigure(reader, node, i));
  });
  return suite;
}

Suite loadSuite(const std::string& nameOrFile) {
  for (const auto& [name, text] : kBuiltinSuites)
    if (name == nameOrFile) {
      Suite suite = parseSuite(text, "suites/" + nameOrFile + ".toml");
      suite.name = nameOrFile;
      return suite;
    }
  if (!nameOrFile.ends_with(".toml"))
    throw InputError("--suite", unknownName("suite", nameOrFile, builtinSuites()) +
                                    " (or a file that ends in .toml)");
  try {
    return parseSuite(report::readBounded(nameOrFile, kSuiteBytes), nameOrFile);
  } catch (const std::runtime_error& e) {
    if (dynamic_cast<const InputError*>(&e)) throw;
    throw InputError("--suite", e.what());
  }
}

std::vector<CellId> suiteCells(const Suite& suite, const Selection& over,
                               const std::vector<std::string>& knownBackends,
                               const std::vector<std::string>& defaultBackends) {
  if (suite.runs.empty()) return {};
  requireKnownBackends(over.backends, knownBackends);
  std::vector<CellId> cells;
  std::set<CellId> known;
  for (const SuiteRun& run : suite.runs)
    for (Selection selection : run.selections) {
      if (!over.backends.empty()) selection.backends = over.backends;
      if (over.size) selection.size = over.size;
      selection.seed = over.seed;
      for (CellId& id : cellsOf(selection, knownBackends, defaultBackends, run.where))
        if (known.insert(id).second) cells.push_back(std::move(id));
    }
  return filterCells(over, cells);
}

}  // namespace sb
