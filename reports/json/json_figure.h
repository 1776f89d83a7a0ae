// Figures in JSON: key `figures` beside `benchmarks`, a list of objects
//   id, title, kind, document, x, x_fallback, cells[], missing[], stated[{cells, passes,
//   attachments, bytes}], statements[{text, of, left{cells, measure, at}, right{..} or number,
//   relation, factor, otherwise, verdict, found, why}]
// Verdicts and what is missing are for other programs: reading a run finds them anew.
#pragma once

#include "reports/json/json_error.h"
#include "reports/json/json_field.h"

namespace report {

Json figureToJson(const Figure& figure, const Run& run);
Figure readFigure(const Field& field);

}  // namespace report
