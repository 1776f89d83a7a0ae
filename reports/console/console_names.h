// Names of cells for tables: a scene whose name would push every column off the screen (a long
// path, many edits) is numbered, and stands in full below.
#pragma once

#include "reports/record.h"

namespace report {

class CellNames {
 public:
  static constexpr size_t kMostOfScene = 48;  ///< characters that a table shows

  /// The cell's name, with "Sponza.gltf[1]" in place of a long scene.
  std::string shown(const Record& record);
  /// "[1] = ..." a line for each; "" when nothing was shortened.
  std::string legend() const;

 private:
  std::vector<std::string> m_scenes;
};

}  // namespace report
