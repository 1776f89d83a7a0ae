#include "suites/harness/suite/suite_reader.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "techniques/plan/error.h"

namespace sb {

void SuiteReader::fail(const toml::node& node, const std::string& field,
                       const std::string& expected) const {
  std::ostringstream found;
  node.visit([&](const auto& value) { found << toml::node_view<const toml::node>(value); });
  throw InputError(at(node) + ": " + field, "found " + found.str() + ", expected " + expected);
}

std::string SuiteReader::at(const toml::node& node) const {
  return m_file + ":" + std::to_string(node.source().begin.line);
}

void SuiteReader::requireKnown(const toml::table& table, const std::string& field,
                               const Texts& known) const {
  for (const auto& [key, node] : table)
    if (std::ranges::find(known, key.str()) == known.end())
      throw InputError(at(node) + (field.empty() ? "" : ": " + field),
                       unknownName("field", key.str(), known));
}

const toml::node& SuiteReader::need(const toml::table& table, const std::string& field,
                                    const char* key) const {
  if (const auto* node = table.get(key)) return *node;
  throw InputError(at(table) + ": " + field, std::string("lacks ") + key);
}

const toml::table& SuiteReader::table(const toml::node& node, const std::string& field) const {
  if (const auto* t = node.as_table()) return *t;
  fail(node, field, "a table");
}

std::string SuiteReader::text(const toml::node& node, const std::string& field) const {
  if (const auto* s = node.as_string()) return s->get();
  fail(node, field, "a text");
}

double SuiteReader::number(const toml::node& node, const std::string& field,
                           const base::NumberRule& rule) const {
  const auto value = node.value<double>();
  if (!value || !base::allows(rule, *value)) fail(node, field, base::describe(rule));
  return *value;
}

bool SuiteReader::boolean(const toml::node& node, const std::string& field) const {
  const auto* value = node.as_boolean();
  if (!value) fail(node, field, "true or false");
  return value->get();
}

std::string SuiteReader::value(const toml::node& node, const std::string& field) const {
  if (const auto* s = node.as_string()) return s->get();
  if (const auto* i = node.as_integer()) return std::to_string(i->get());
  if (const auto* f = node.as_floating_point()) {
    char shortest[32];
    std::snprintf(shortest, sizeof shortest, "%.9g", f->get());
    return shortest;
  }
  fail(node, field, "a number or a text");
}

namespace {

template <class Read>
SuiteReader::Texts listOf(const SuiteReader& reader, const toml::node& node,
                          const std::string& field, const Read& read) {
  const auto* array = node.as_array();
  if (!array || array->empty()) reader.fail(node, field, "a list with at least one entry");
  SuiteReader::Texts out;
  for (const toml::node& item : *array) out.push_back(read(item));
  return out;
}

}  // namespace

SuiteReader::Texts SuiteReader::texts(const toml::node& node, const std::string& field) const {
  return listOf(*this, node, field, [&](const toml::node& n) { return text(n, field); });
}

SuiteReader::Texts SuiteReader::values(const toml::node& node, const std::string& field) const {
  return listOf(*this, node, field, [&](const toml::node& n) { return value(n, field); });
}

SuiteReader::Texts SuiteReader::sets(const toml::table& run, const char* key,
                                     const std::string& field, bool isList) const {
  Texts sets;
  const toml::node* node = run.get(key);
  if (!node) return sets;
  const auto* knobs = node->as_table();
  if (!knobs) fail(*node, field + "." + key, "a table of knobs");
  for (const auto& [knob, entry] : *knobs) {
    const std::string where = field + "." + key + "." + std::string(knob.str());
    std::string joined;
    for (const std::string& v : isList ? values(entry, where) : Texts{value(entry, where)})
      joined += (joined.empty() ? "" : ",") + v;
    sets.push_back(std::string(knob.str()) + "=" + joined);
  }
  return sets;
}

void SuiteReader::eachTable(const toml::table& table, const std::string& field, const char* name,
                            const std::function<void(const toml::node&, size_t)>& parse) const {
  const toml::node* node = table.get(name);
  if (!node) return;
  const auto* list = node->as_array();
  if (!list || list->empty())
    fail(*node, (field.empty() ? "" : field + ".") + name, "tables [[" + std::string(name) + "]]");
  for (size_t i = 0; i < list->size(); ++i) parse(*list->get(i), i);
}

}  // namespace sb
