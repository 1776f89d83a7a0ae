#include "base/pattern.h"

#include <re2/re2.h>

#include <stdexcept>

#include "base/text.h"

namespace base {
namespace {

std::shared_ptr<const re2::RE2> compile(const std::string& text) {
  re2::RE2::Options options;
  options.set_log_errors(false);
  // Names of files need not be UTF-8, and then nothing would match.
  if (!isUtf8(text)) options.set_encoding(re2::RE2::Options::EncodingLatin1);
  auto compiled = std::make_shared<re2::RE2>(text, options);
  if (!compiled->ok()) throw std::invalid_argument(compiled->error());
  return compiled;
}

}  // namespace

Pattern Pattern::regex(std::string_view text) { return Pattern(compile(std::string(text))); }

Pattern Pattern::glob(std::string_view text) {
  std::string regex = "(?s)^";
  for (const char c : text) {
    if (c == '*')
      regex += ".*";
    else if (c == '?')
      regex += '.';
    else
      regex += re2::RE2::QuoteMeta(re2::StringPiece(&c, 1));
  }
  return Pattern(compile(regex + "$"));
}

bool Pattern::found(std::string_view text) const {
  return re2::RE2::PartialMatch(re2::StringPiece(text.data(), text.size()), *m_compiled);
}

}  // namespace base
