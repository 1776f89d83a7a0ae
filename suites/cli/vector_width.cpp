#include "suites/cli/vector_width.h"

#include <cstdint>
#include <cstdlib>

#include "base/number.h"

namespace sb {
namespace {

constexpr const char* kVariable = "LP_NATIVE_VECTOR_WIDTH";

/// Of this CPU's vectors, in bits; the driver looks at the same features.
uint64_t widest() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx512f") ? 512 : __builtin_cpu_supports("avx") ? 256 : 128;
#else
  return 128;
#endif
}

std::string usable() {
  std::string list = "128";
  for (uint64_t bits = 256; bits <= widest(); bits *= 2) list += " or " + std::to_string(bits);
  return list;
}

}  // namespace

std::string vectorWidth() {
  const char* value = std::getenv(kVariable);
  return value ? value : "";
}

std::string whyNoVectorWidth(const std::string& value) {
  if (value.empty()) return "";
  const auto bits = base::readWhole(value, 128, widest());
  if (bits && (*bits & (*bits - 1)) == 0) return "";
  return "is '" + value + "', with which Mesa's llvmpipe crashes or hangs; expected " + usable() +
         " on this CPU, or to be unset";
}

std::string vectorWidthNote(const std::string& value) {
  return std::string(kVariable) + "=" + value +
         ": software devices run at this width, and times are of it alone; "
         "Mesa's shader cache is not used, for it mixes up widths and corrupts the heap";
}

void guardVectorWidth() {
  const std::string value = vectorWidth();
  if (value.empty()) return;
  if (whyNoVectorWidth(value).empty())
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  else
    unsetenv(kVariable);
}

}  // namespace sb
