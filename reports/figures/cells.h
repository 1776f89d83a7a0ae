// The cells of a figure: which were measured, which are missing, and why.
#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "reports/record.h"

namespace report {

/// Finds `regex` within the name; what is no regular expression is found nowhere.
bool matchesRegex(const std::string& regex, const std::string& name);

/// Records of the figure's cells, in the run's order.
std::vector<const Record*> recordsOf(const Figure& figure, const Run& run);
/// Cells of the figure that the run has no result of, each with the reason: "NAME: failed, ...".
std::vector<std::string> missingCells(const Figure& figure, const Run& run);
/// In order of appearance.
std::vector<std::string> backendsOf(const std::vector<const Record*>& records);
/// Why no side of a statement has a value: the first cell that lacks one, of a backend that was
/// measured if there is any.
std::string whyLacking(const Figure& figure, const FigureStatement& statement, const Run& run);

}  // namespace report
