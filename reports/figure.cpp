#include "reports/figure.h"

namespace report {

std::string_view figureKindName(FigureKind kind) {
  switch (kind) {
    case FigureKind::Scaling:
      return "scaling";
    case FigureKind::Pictures:
      return "pictures";
    case FigureKind::Layers:
      return "layers";
    case FigureKind::Regions:
      return "regions";
    case FigureKind::Resources:
      return "resources";
  }
  return "";
}

}  // namespace report
