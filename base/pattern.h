// Regular expressions and globs, matched in time linear in the text (RE2): a pattern from a user or
// a file can neither overflow the stack nor run for ever.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace re2 {
class RE2;
}

namespace base {

class Pattern {
 public:
  /// RE2's syntax (no back references, no look-around). Throws std::invalid_argument saying what is
  /// wrong with it. An empty one is found in everything.
  static Pattern regex(std::string_view text);
  /// `*` stands for any characters, `?` for one; the whole name must match.
  static Pattern glob(std::string_view text);

  /// Somewhere in `text`; of a glob: all of it.
  bool found(std::string_view text) const;

 private:
  explicit Pattern(std::shared_ptr<const re2::RE2> compiled) : m_compiled(std::move(compiled)) {}
  std::shared_ptr<const re2::RE2> m_compiled;
};

}  // namespace base
