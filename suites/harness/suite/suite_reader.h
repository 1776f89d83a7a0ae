// Fields of a suite file: whatever is not as it should be is an error that names file, line, field,
// what was found and what was expected.
#pragma once

#include <toml++/toml.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/number.h"

namespace sb {

class SuiteReader {
 public:
  using Texts = std::vector<std::string>;

  explicit SuiteReader(std::string file) : m_file(std::move(file)) {}

  [[noreturn]] void fail(const toml::node& node, const std::string& field,
                         const std::string& expected) const;
  /// "FILE:line"
  std::string at(const toml::node& node) const;
  void requireKnown(const toml::table& table, const std::string& field, const Texts& known) const;
  /// A key that must be there.
  const toml::node& need(const toml::table& table, const std::string& field, const char* key) const;

  const toml::table& table(const toml::node& node, const std::string& field) const;
  std::string text(const toml::node& node, const std::string& field) const;
  double number(const toml::node& node, const std::string& field,
                const base::NumberRule& rule) const;
  bool boolean(const toml::node& node, const std::string& field) const;
  /// A knob's value: a text or a number.
  std::string value(const toml::node& node, const std::string& field) const;
  Texts texts(const toml::node& node, const std::string& field) const;
  Texts values(const toml::node& node, const std::string& field) const;
  /// "knob=v1,v2" of every entry of a table of knobs.
  Texts sets(const toml::table& run, const char* key, const std::string& field, bool isList) const;
  /// Calls `parse` for the tables [[name]], which may be missing; `field` goes before the name.
  void eachTable(const toml::table& table, const std::string& field, const char* name,
                 const std::function<void(const toml::node&, size_t)>& parse) const;

 private:
  std::string m_file;
};

}  // namespace sb
