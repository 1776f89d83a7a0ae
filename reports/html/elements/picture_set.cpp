#include "reports/html/elements/picture_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "reports/html/elements/text.h"

namespace report {
namespace {

/// Hashes name files; anything else in a file from elsewhere might name a file that is none of
/// ours.
bool isHash(const std::string& text) {
  return !text.empty() && text.size() <= 64 &&
         text.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
}

std::string readFile(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return "";
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string joined(const std::set<std::string>& names) {
  constexpr size_t kShown = 3;
  std::string out;
  size_t n = 0;
  for (const std::string& name : names) {
    if (n++ == kShown) return out + fmt::format(" and {} more", names.size() - kShown);
    out += (out.empty() ? "" : ", ") + name;
  }
  return out;
}

}  // namespace

std::string PictureSet::html(const Record& record, const std::string& role,
                             const std::string& alternative) {
  const auto found = record.pictures.find(role);
  if (found == record.pictures.end()) return "<p class=\"no-picture\">not made</p>";
  const std::string& hash = found->second;
  if (!isHash(hash)) {
    m_refused.insert(hash);
    return "<p class=\"no-picture\">refused: its name is no hash</p>";
  }
  const std::string attributes =
      fmt::format("width=\"{}\" height=\"{}\" alt=\"{}\" data-picture=\"{}\"", record.id.width,
                  record.id.height, escaped(alternative), hash);
  if (m_embedded.contains(hash)) return "<img " + attributes + ">";
  const std::string png = m_folder.empty() ? "" : readFile(m_folder / (hash + ".png"));
  if (!png.starts_with("\x89PNG\r\n\x1a\n")) {
    m_missing.insert(hash + ".png");
    return "<p class=\"no-picture\">missing: " + hash + ".png</p>";
  }
  m_embedded.insert(hash);
  m_bytes += png.size();
  return "<img " + attributes + " src=\"data:image/png;base64," + base64(png) + "\">";
}

std::string PictureSet::shown(const Record& record, const std::string& role) const {
  const auto found = record.pictures.find(role);
  return found != record.pictures.end() && m_embedded.contains(found->second) ? found->second : "";
}

std::vector<std::string> PictureSet::notes() const {
  std::vector<std::string> out;
  if (!m_missing.empty())
    out.push_back(counted(m_missing.size(), "picture is", "pictures are") + " missing in " +
                  (m_folder.empty() ? "this report, which was made without a folder of pictures"
                                    : m_folder.filename().string()) +
                  ": " + joined(m_missing));
  if (!m_refused.empty())
    out.push_back(counted(m_refused.size(), "name of a picture is", "names of pictures are") +
                  " no hash, and not looked for: " + joined(m_refused));
  return out;
}

}  // namespace report
