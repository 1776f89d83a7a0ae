#include "reports/cell_id.h"

#include "base/text.h"

namespace report {

std::string techniqueName(const std::string& technique, const std::string& transparency,
                          const std::string& lights) {
  std::string name = technique;
  if (transparency != kDefaultTransparency) name += "+" + transparency;
  if (lights != kDefaultLights) name += "@" + lights;
  return name;
}

std::string techniqueName(const CellId& id) {
  return techniqueName(id.technique, id.transparency, id.lights);
}

std::string cellName(const CellId& id) {
  // Files may be called anything: names go to terminals, tables and filters.
  std::string name = techniqueName(id) + "/" + id.backend + "/" + base::printable(id.scene);
  for (const auto& [knob, value] : id.knobs) name += "/" + knob + ":" + value;
  if (id.seed != 0) name += "/seed:" + std::to_string(id.seed);
  return name + "/" + std::to_string(id.width) + "x" + std::to_string(id.height);
}

std::string_view roleName(Role role) {
  switch (role) {
    case Role::Technique:
      return "technique";
    case Role::Baseline:
      return "baseline";
    case Role::Tracer:
      break;
  }
  return "tracer";
}

}  // namespace report
