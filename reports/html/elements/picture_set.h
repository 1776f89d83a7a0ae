// The pictures of a page: each file is embedded once, however many cells show it.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "reports/record.h"

namespace report {

class PictureSet {
 public:
  explicit PictureSet(std::filesystem::path folder) : m_folder(std::move(folder)) {}

  /// <img> of a record's picture. The first of a hash carries the file; later ones point to it, and
  /// the page's script fills them in. A note instead when there is no such file.
  std::string html(const Record& record, const std::string& role, const std::string& alternative);
  /// The hash, when the record names one for this role and html() found its file; else "".
  std::string shown(const Record& record, const std::string& role) const;

  /// One sentence a kind of trouble, plain text.
  std::vector<std::string> notes() const;
  /// The embedded files as PNG are together this large.
  size_t bytes() const { return m_bytes; }

 private:
  std::filesystem::path m_folder;
  std::set<std::string> m_embedded, m_missing, m_refused;
  size_t m_bytes = 0;
};

}  // namespace report
