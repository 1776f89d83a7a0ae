// Errors of pictures and of visibility against the truth (spec 16, Error metrics).
#pragma once

#include <span>

#include "reports/error_record.h"
#include "reports/picture.h"

namespace sb {

/// RGBA values of `width * height` pixels, alpha 1 where there is a value.
using Values = std::span<const float>;

/// Error over the pixels whose alpha is 1 in both and, if given, whose mask is 0. Sizes are equal.
report::ErrorStats errorOf(Values measured, Values truth, std::span<const uint8_t> mask = {});

/// Adds up the errors of several layers: as errorOf over all their pixels together. Holds what it is
/// given until `stats`.
class ErrorSum {
 public:
  void add(Values measured, Values truth, std::span<const uint8_t> mask = {});
  report::ErrorStats stats() const;

 private:
  std::vector<float> m_differences;  ///< three a pixel
};

/// Pixels where one of the two alone shows a surface: `measured` by its alpha, the truth by `surfaces`
/// (not 0). Those whose mask is not 0, if given, are left out.
uint64_t oneSided(Values measured, std::span<const uint8_t> surfaces,
                  std::span<const uint8_t> mask = {});

/// Error of a picture; `edges` as in Truth::imageEdges.
report::ImageError imageError(const report::Picture& measured, const report::Picture& truth,
                              std::span<const uint8_t> edges);

}  // namespace sb
