// Errors of input, and near names for them. Exit code of the program: 2.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace sb {

/// The user's input is wrong. The text names where (file, field or option), what was found and what
/// was expected; nothing has been written.
class InputError : public std::runtime_error {
 public:
  InputError(std::string where, std::string what)
      : std::runtime_error(where.empty() ? what : where + ": " + what), m_where(std::move(where)) {}
  const std::string& where() const { return m_where; }

 private:
  std::string m_where;
};

/// Up to `count` of `names` nearest to `name` (edit distance, prefixes first), for error texts.
std::vector<std::string> nearestNames(std::string_view name, std::span<const std::string> names,
                                      size_t count = 3);
/// "unknown KIND 'NAME'; did you mean A, B or C?" - the standard wording.
std::string unknownName(std::string_view kind, std::string_view name,
                        std::span<const std::string> names);

}  // namespace sb
