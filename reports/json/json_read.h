// Results read back from JSON: the inverse of reports/json/json.h. Keys that a file of an older version
// does not have are absent values; keys that are there must be what they should be. Nothing is
// guessed: a file that is no result of ours is refused with the field that says so.
#pragma once

#include <stdexcept>
#include <string>

#include "reports/record.h"

namespace report {

/// A file of results is not what it should be: "FILE: FIELD: found X, expected Y".
class ReadError : public std::runtime_error {
 public:
  ReadError(const std::string& file, const std::string& field, const std::string& what)
      : std::runtime_error(file + ": " + (field.empty() ? "" : field + ": ") + what),
        m_field(field) {}
  /// Path within the file, "benchmarks[2].frame_ms.median"; empty when it is the file as a whole.
  const std::string& field() const { return m_field; }

 private:
  std::string m_field;
};

/// The run that toJson wrote as `text`. `fileName` is for the texts of errors alone. Throws
/// ReadError.
Run fromJson(const std::string& text, const std::string& fileName);

}  // namespace report
