#include "suites/harness/suite.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>
#include <toml++/toml.h>

#include "suites/harness/builtin_suites.h"
#include "techniques/common/error.h"

namespace sb {
namespace {

using Values = std::vector<std::string>;

/// Reads fields of one file; errors name file, line and field.
class Reader {
 public:
  explicit Reader(std::string file) : m_file(std::move(file)) {}

  [[noreturn]] void fail(const toml::node& node, const std::string& field,
                         const std::string& expected) const {
    std::ostringstream found;
    node.visit([&](const auto& value) { found << toml::node_view<const toml::node>(value); });
    throw InputError(at(node) + ": " + field, "found " + found.str() + ", expected " + expected);
  }

  std::string at(const toml::node& node) const {
    return m_file + ":" + std::to_string(node.source().begin.line);
  }

  void requireKnown(const toml::table& table, const std::string& field, const Values& known) const {
    for (const auto& [key, node] : table)
      if (std::ranges::find(known, key.str()) == known.end())
        throw InputError(at(node) + (field.empty() ? "" : ": " + field),
                         unknownName("field", key.str(), known));
  }

  std::string text(const toml::node& node, const std::string& field) const {
    if (const auto* s = node.as_string()) return s->get();
    fail(node, field, "a text");
  }

  double number(const toml::node& node, const std::string& field, double low) const {
    const auto value = node.value<double>();
    if (!value || !(*value > low) || !std::isfinite(*value)) {
      char least[32];
      std::snprintf(least, sizeof least, "%g", low);
      fail(node, field, std::string("a number above ") + least);
    }
    return *value;
  }

  /// A knob's value: a text or a number.
  std::string value(const toml::node& node, const std::string& field) const {
    if (const auto* s = node.as_string()) return s->get();
    if (const auto* i = node.as_integer()) return std::to_string(i->get());
    if (const auto* f = node.as_floating_point()) {
      char shortest[32];
      std::snprintf(shortest, sizeof shortest, "%.9g", f->get());
      return shortest;
    }
    fail(node, field, "a number or a text");
  }

  template <class Read>
  Values list(const toml::node& node, const std::string& field, const Read& read) const {
    const auto* array = node.as_array();
    if (!array || array->empty()) fail(node, field, "a list with at least one entry");
    Values values;
    for (const toml::node& item : *array) values.push_back(read(item, field));
    return values;
  }
  Values texts(const toml::node& node, const std::string& field) const {
    return list(node, field, [&](auto& n, auto& f) { return text(n, f); });
  }
  Values values(const toml::node& node, const std::string& field) const {
    return list(node, field, [&](auto& n, auto& f) { return value(n, f); });
  }

  /// "knob=v1,v2" of every entry of a table of knobs.
  Values sets(const toml::table& run, const char* key, const std::string& field,
              bool isList) const {
    Values sets;
    const toml::node* node = run.get(key);
    if (!node) return sets;
    const auto* table = node->as_table();
    if (!table) fail(*node, field + "." + key, "a table of knobs");
    for (const auto& [knob, entry] : *table) {
      const std::string where = field + "." + key + "." + std::string(knob.str());
      std::string joined;
      for (const std::string& v : isList ? values(entry, where) : Values{value(entry, where)})
        joined += (joined.empty() ? "" : ",") + v;
      sets.push_back(std::string(knob.str()) + "=" + joined);
    }
    return sets;
  }

  /// One set of knobs for each value of each entry of `sweep`, or one alone, all with those of
  /// `set`.
  std::vector<std::map<std::string, std::string>> variants(const toml::table& run,
                                                           const std::string& field) const {
    std::map<std::string, std::string> fixed;
    for (const std::string& text : sets(run, "set", field, false))
      fixed[text.substr(0, text.find('='))] = text.substr(text.find('=') + 1);
    std::vector<std::map<std::string, std::string>> all;
    for (const std::string& text : sets(run, "sweep", field, true)) {
      std::stringstream list(text.substr(text.find('=') + 1));
      for (std::string value; std::getline(list, value, ',');) {
        all.push_back(fixed);
        all.back()[text.substr(0, text.find('='))] = value;
      }
    }
    if (all.empty()) all.push_back(fixed);
    return all;
  }

 private:
  std::string m_file;
};

std::pair<uint32_t, uint32_t> sizeOf(const Reader& reader, const toml::node& node,
                                     const std::string& field) {
  unsigned width = 0, height = 0;
  int used = 0;
  const std::string text = reader.text(node, field);
  if (std::sscanf(text.c_str(), "%ux%u%n", &width, &height, &used) != 2 ||
      size_t(used) != text.size() || width < 1 || height < 1 || width > 16384 || height > 16384)
    reader.fail(node, field, "\"WIDTHxHEIGHT\", each 1..16384");
  return {width, height};
}

SuiteRun parseRun(const Reader& reader, const toml::node& node, size_t index) {
  const std::string field = "run " + std::to_string(index + 1);
  const auto* table = node.as_table();
  if (!table) reader.fail(node, field, "a table");
  reader.requireKnown(*table, field,
                      {"scenes", "techniques", "backends", "size", "set", "grid", "sweep"});
  Selection base;
  for (const char* key : {"scenes", "techniques"})
    if (!table->get(key)) throw InputError(reader.at(node) + ": " + field, std::string("lacks ") + key);
  base.scenes = reader.texts(*table->get("scenes"), field + ".scenes");
  base.techniques = reader.texts(*table->get("techniques"), field + ".techniques");
  if (const auto* n = table->get("backends")) base.backends = reader.texts(*n, field + ".backends");
  if (const auto* n = table->get("size")) base.size = sizeOf(reader, *n, field + ".size");
  base.sets = reader.sets(*table, "set", field, false);
  const Values grid = reader.sets(*table, "grid", field, true);
  base.sets.insert(base.sets.end(), grid.begin(), grid.end());
  SuiteRun run{.where = reader.at(node) + ": " + field, .selections = {base}};
  for (const std::string& sweep : reader.sets(*table, "sweep", field, true)) {
    Selection swept = base;
    swept.sets.push_back(sweep);
    run.selections.push_back(std::move(swept));
  }
  return run;
}

StabilityRun parseStability(const Reader& reader, const toml::node& node, size_t index) {
  const std::string field = "stability " + std::to_string(index + 1);
  const auto* table = node.as_table();
  if (!table) reader.fail(node, field, "a table");
  reader.requireKnown(*table, field, {"cases", "techniques", "set", "sweep", "seeds"});
  StabilityRun run{.where = reader.at(node) + ": " + field};
  run.variants = reader.variants(*table, field);
  if (const auto* n = table->get("seeds"))
    run.seeds = uint32_t(reader.number(*n, field + ".seeds", 0));
  if (const auto* n = table->get("cases")) run.cases = reader.texts(*n, field + ".cases");
  if (const auto* n = table->get("techniques"))
    run.techniques = reader.texts(*n, field + ".techniques");
  return run;
}

/// Calls `parse` for the tables [[name]], which may be missing.
void eachTable(const Reader& reader, const toml::table& root, const char* name, const auto& parse) {
  const toml::node* node = root.get(name);
  if (!node) return;
  const auto* list = node->as_array();
  if (!list || list->empty()) reader.fail(*node, name, "tables [[" + std::string(name) + "]]");
  for (size_t i = 0; i < list->size(); ++i) parse(*list->get(i), i);
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

Suite parseSuite(std::string_view text, const std::string& file) {
  const Reader reader(file);
  toml::table root;
  try {
    root = toml::parse(text, file);
  } catch (const toml::parse_error& e) {
    throw InputError(file + ":" + std::to_string(e.source().begin.line),
                     std::string(e.description()));
  }
  reader.requireKnown(root, "", {"title", "seeds", "budget", "precision", "run", "stability"});
  Suite suite{.name = file};
  if (const auto* n = root.get("title")) suite.title = reader.text(*n, "title");
  if (const auto* n = root.get("seeds")) suite.seeds = uint32_t(reader.number(*n, "seeds", 0));
  if (const auto* n = root.get("budget")) suite.budgetSeconds = reader.number(*n, "budget", 0);
  if (const auto* n = root.get("precision"))
    suite.precisionPercent = reader.number(*n, "precision", 0);
  if (!root.get("run") && !root.get("stability"))
    throw InputError(file, "has no [[run]] and no [[stability]]");
  eachTable(reader, root, "run", [&](const toml::node& node, size_t i) {
    suite.runs.push_back(parseRun(reader, node, i));
  });
  eachTable(reader, root, "stability", [&](const toml::node& node, size_t i) {
    suite.stability.push_back(parseStability(reader, node, i));
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
  std::ifstream in(nameOrFile, std::ios::binary);
  if (!in) throw InputError("--suite", "cannot read " + nameOrFile);
  std::ostringstream text;
  text << in.rdbuf();
  return parseSuite(text.str(), nameOrFile);
}

std::vector<CellId> suiteCells(const Suite& suite, const Selection& over,
                               const std::vector<std::string>& knownBackends,
                               const std::vector<std::string>& defaultBackends) {
  if (suite.runs.empty()) return {};
  std::vector<CellId> cells;
  std::set<std::string> names;
  for (const SuiteRun& run : suite.runs)
    for (Selection selection : run.selections) {
      if (!over.backends.empty()) selection.backends = over.backends;
      if (over.size) selection.size = over.size;
      selection.seed = over.seed;
      for (CellId& id : cellsOf(selection, knownBackends, defaultBackends, run.where))
        if (names.insert(cellName(id)).second) cells.push_back(std::move(id));
    }
  return filterCells(over, cells);
}

}  // namespace sb
