#include "reports/console/console_names.h"

#include <fmt/format.h>

#include <algorithm>

namespace report {

std::string CellNames::shown(const Record& record) {
  const std::string& scene = record.id.scene;
  if (scene.size() <= kMostOfScene) return record.name;
  auto known = std::ranges::find(m_scenes, scene);
  if (known == m_scenes.end()) known = m_scenes.insert(known, scene);
  const std::string file = scene.substr(0, scene.find('?'));
  CellId id = record.id;
  id.scene = fmt::format("{}[{}]", file.substr(file.rfind('/') + 1),  // npos + 1 is 0
                         known - m_scenes.begin() + 1);
  return cellName(id);
}

std::string CellNames::legend() const {
  std::string out;
  for (size_t i = 0; i < m_scenes.size(); ++i)
    out += fmt::format("[{}] = {}\n", i + 1, m_scenes[i]);
  return out;
}

}  // namespace report
