#include "suites/cli/progress.h"

#include <unistd.h>

#include <cstdio>

namespace sb {

Progress::Progress(bool show) : m_show(show), m_terminal(isatty(2) != 0) {}

Progress::~Progress() {
  if (m_show && m_terminal) std::fprintf(stderr, "\r\033[K");
}

void Progress::update(const std::string& scene, const std::string& what, double done) {
  if (!m_show) return;
  if (m_terminal) {
    std::fprintf(stderr, "\r\033[K[%3.0f %%] %s: %s", 100 * done, scene.c_str(), what.c_str());
    std::fflush(stderr);
    return;
  }
  // In a log: when the scene changes, and every tenth of the run.
  const int tenth = int(10 * done);
  if (scene == m_scene && tenth == m_tenth) return;
  m_scene = scene;
  m_tenth = tenth;
  std::fprintf(stderr, "[%3.0f %%] %s: %s\n", 100 * done, scene.c_str(), what.c_str());
}

}  // namespace sb
