// Figures on the console: a table each, and what of the document was reproduced.
#pragma once

#include <string>

#include "reports/record.h"

namespace report {

/// Empty without figures.
std::string figuresText(const Run& run);

}  // namespace report
