#include "suites/cli/progress.h"

#include <unistd.h>

#include <cstdio>

#include "base/text.h"

namespace sb {

Progress::Progress(bool show) : m_show(show), m_terminal(isatty(2) != 0) {}

Progress::~Progress() {
  if (m_show && m_terminal) std::fprintf(stderr, "\r\033[K");
}

void Progress::update(const std::string& scene, const std::string& what, double done) {
  if (!m_show) return;
  const std::string shown = base::errorLine(scene + ": " + what);
  if (m_terminal) {
    std::fprintf(stderr, "\r\033[K[%3.0f %%] %s", 100 * done, shown.c_str());
    std::fflush(stderr);
    return;
  }
  // In a log: when the scene changes, and every tenth of the run.
  const int tenth = int(10 * done);
  if (scene == m_scene && tenth == m_tenth) return;
  m_scene = scene;
  m_tenth = tenth;
  std::fprintf(stderr, "[%3.0f %%] %s\n", 100 * done, shown.c_str());
}

}  // namespace sb
