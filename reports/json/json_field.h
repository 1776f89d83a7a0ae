// A value of a JSON file together with the path to it, so that every complaint about a file says
// where, what was found and what was expected. Reading never converts silently: a text is no
// number, and a number that its field cannot hold is refused.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "reports/json/json_error.h"

namespace report {

class Field {
 public:
  /// The whole file. `root` and `file` must outlive this and all that comes from it.
  Field(const Json& root, const std::string& file) : m_value(&root), m_file(&file) {}

  /// A key that must be there.
  Field at(const std::string& key) const;
  /// A key that may be missing or null.
  std::optional<Field> find(const std::string& key) const;
  std::vector<Field> items() const;                            ///< of an array
  std::vector<std::pair<std::string, Field>> members() const;  ///< of an object, in order

  bool isNull() const { return m_value->is_null(); }
  std::string text() const;
  bool boolean() const;
  double number() const;
  template <class T>
  T integer() const {
    return T(integerWithin(std::numeric_limits<T>::max()));
  }
  int signedInteger() const;

  /// Throws ReadError: "FILE: PATH: found X, expected Y".
  [[noreturn]] void refuse(const std::string& expected) const;

 private:
  Field(const Json& value, const std::string& file, std::string path)
      : m_value(&value), m_file(&file), m_path(std::move(path)) {}
  void requireObject() const;
  uint64_t integerWithin(uint64_t most) const;
  std::string child(const std::string& key) const;

  const Json* m_value;
  const std::string* m_file;
  std::string m_path;  ///< "benchmarks[2].frame_ms"
};

// Values that files of older versions lack: then "", an empty list, 0, nothing.
std::string textOf(const Field& object, const std::string& key);
std::vector<std::string> textsOf(const Field& object, const std::string& key);
uint64_t countOf(const Field& object, const std::string& key);
std::optional<double> numberOf(const Field& object, const std::string& key);

}  // namespace report
