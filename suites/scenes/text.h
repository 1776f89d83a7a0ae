// Text from files made fit for terminals and reports. The one place where names, warnings and error
// texts of scene files are cleaned.
#pragma once

#include <string>
#include <string_view>

#include "techniques/common/scene.h"

namespace sb {

/// UTF-8 with every byte that is none and every control or direction character (C0, C1, DEL, bidi
/// marks and overrides, line separators) replaced by U+FFFD.
std::string printable(std::string_view text);
/// At most `most` bytes: the middle gives way to "...", for both ends of a message matter.
/// Characters stay whole.
std::string shortened(std::string_view text, size_t most);
/// printable() for every name and warning of a scene.
void cleanNames(Scene& scene);

}  // namespace sb
