#include "suites/cli/say.h"

#include <cstdio>

#include "base/text.h"

namespace sb {

void say(std::string_view text) {
  static constexpr std::string_view kProgram = "bench: ";
  std::fprintf(stderr, "%s\n", base::errorLine(std::string(kProgram) + std::string(text)).c_str());
}

void note(std::string_view text) {
  std::fprintf(stderr, "bench: %s\n", base::printable(text).c_str());
}

void print(std::string_view text) {
  const std::string lines = base::printableLines(text);
  std::fwrite(lines.data(), 1, lines.size(), stdout);
}

bool printed() { return std::fflush(stdout) == 0 && !std::ferror(stdout); }

}  // namespace sb
