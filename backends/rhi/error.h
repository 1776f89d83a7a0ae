// The one exception type of the RHI, and the expected absence of a thing.
#pragma once

#include <source_location>
#include <stdexcept>
#include <string>

namespace rhi {

/// A runtime failure of a device, a driver or a shader. Carries the native call, the native code's
/// name (e.g. "VK_ERROR_DEVICE_LOST", "GL_OUT_OF_MEMORY", or "" where there is none) and a detail
/// for people. Programmer errors are asserts, never this.
class Error : public std::runtime_error {
 public:
  Error(std::string call, std::string code, std::string detail,
        std::source_location where = std::source_location::current())
      : std::runtime_error(call + (code.empty() ? "" : " failed with " + code) +
                           (detail.empty() ? "" : ": " + detail)),
        m_call(std::move(call)), m_code(std::move(code)), m_detail(std::move(detail)),
        m_where(where) {}
  const std::string& call() const { return m_call; }
  const std::string& code() const { return m_code; }
  const std::string& detail() const { return m_detail; }
  const std::source_location& where() const { return m_where; }

 private:
  std::string m_call, m_code, m_detail;
  std::source_location m_where;
};

/// The device does nothing any more, whatever is asked of it.
inline bool isDeviceLost(const Error& error) {
  return error.code() == "VK_ERROR_DEVICE_LOST" || error.code() == "GL_CONTEXT_LOST";
}
/// What the device says it lacks: an expected absence that shows only in use.
inline bool isDeclaredLack(const Error& error) {
  return error.code() == "VK_ERROR_FORMAT_NOT_SUPPORTED" ||
         error.code() == "VK_ERROR_FEATURE_NOT_PRESENT" ||
         error.code() == "VK_ERROR_EXTENSION_NOT_PRESENT";
}

/// An expected absence: the thing asked for does not exist here, for this reason.
struct Skip {
  std::string reason;
};

}  // namespace rhi
