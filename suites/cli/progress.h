// Progress on standard error: one line that is rewritten on a terminal, a line now and then in a
// log.
#pragma once

#include <string>

namespace sb {

class Progress {
 public:
  explicit Progress(bool show);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of the whole run, 0..1.
  void update(const std::string& scene, const std::string& what, double done);

 private:
  bool m_show;
  bool m_terminal;
  std::string m_scene;  ///< of the last line of a log
  int m_tenth = -1;
};

}  // namespace sb
