#include "reports/html/elements/curve_set.h"

#include <cmath>

namespace report {
namespace {

Json pointsJson(const std::vector<std::array<double, 2>>& points) {
  Json out = Json::array();
  for (const auto& [x, y] : points)
    if (std::isfinite(x) && std::isfinite(y)) out.push_back({x, y});
  return out;
}

}  // namespace

std::string CurveSet::html(Curve curve, const std::string& caption) {
  const std::string id = std::to_string(m_curves.size());
  m_curves.push_back(std::move(curve));
  return "<figure class=\"curve\">\n<div class=\"lines\" data-curve=\"" + id +
         "\"></div>\n<figcaption>" + caption + "</figcaption>\n</figure>\n";
}

Json CurveSet::json(const PageModel& model) const {
  Json out = Json::array();
  for (const Curve& c : m_curves) {
    Json lines = Json::array();
    for (const CurveLine& l : c.lines)
      lines.push_back({{"technique", l.technique},
                       {"backend", l.backend},
                       {"color", model.colorClass(l.technique)},
                       {"shape", model.shapeClass(l.backend)},
                       {"label", l.label},
                       {"points", pointsJson(l.points)},
                       {"limit", pointsJson(l.limit)},
                       {"breaksAt", l.breaksAt ? Json(*l.breaksAt) : Json(nullptr)}});
    out.push_back({{"xTitle", c.xTitle},
                   {"yTitle", c.yTitle},
                   {"logX", c.logarithmicX},
                   {"wideY", c.wideY},
                   {"lines", std::move(lines)}});
  }
  return out;
}

}  // namespace report
