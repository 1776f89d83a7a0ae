// Figures of a suite: what of a document its cells show again (reports/figure.h). Format:
//   [[figure]]
//   id = "5.3.A"                    as the document numbers it
//   title = "..."
//   kind = "scaling"                or pictures, layers, regions, resources
//   cells = "REGEX"                 optional: which of the suite's cells; default all
//   x = "quads"                     of scaling: a parameter of the scenes, or a knob
//   document = "..."                what the document shows and says, in our words
//   [[figure.statement]]            a claim that can be checked
//   text = "..."
//   of = "slope"                    optional: value (default), slope, intercept (over x), each
//   measure = "combined_ms"         see reports/figures/measure.h
//   left = "REGEX"                  cells of the left side
//   right = "REGEX"                 of the right side; optional beside right_measure, right_at, and
//   number = 1                      instead of a right side
//   right_measure = "..."           optional: another measure
//   at = 2000                       optional: cells with this x alone; left_at, right_at of a side
//   relation = "less"               or more, about
//   factor = 2                      optional: times
//   otherwise = "..."               why it is not reproduced, when it is not
//   [[figure.stated]]               of resources: what the document states
//   cells = "REGEX"
//   passes = "..."                  optional, as are attachments and bytes
#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "suites/harness/suite/suite_reader.h"

namespace sb {

struct SuiteFigure {
  std::string where;      ///< "FILE:line: figure N", for errors
  std::string cells;      ///< regular expression
  report::Figure figure;  ///< without cells
};

/// Throws InputError with file, line and field.
SuiteFigure parseFigure(const SuiteReader& reader, const toml::node& node, size_t index);

struct Suite;
struct Selection;

/// The figures of a suite with their cells, measured or filtered out. Throws
/// InputError for a figure or a statement that no cell belongs to, and for an x that its cells do
/// not have.
std::vector<report::Figure> suiteFigures(const Suite& suite, const Selection& over,
                                         const std::vector<std::string>& knownBackends,
                                         const std::vector<std::string>& defaultBackends);

}  // namespace sb
