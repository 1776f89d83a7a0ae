// Tables of the page. Each is the text alternative of a plot or stands for itself; rows carry what
// filters ask for, cells the number they are sorted by.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace report {

struct TableColumn {
  std::string title;  ///< plain text
  bool number = false;
  std::string hint = {};       ///< what the figures are, for the header's tooltip
  std::string technique = {};  ///< the column goes with this technique's filter
};

struct TableEntry {
  std::string html;
  std::optional<double> value = {};  ///< sorted by this; absent values go last
  std::string technique = {};
};

struct TableLine {
  std::string technique, backend;
  std::vector<TableEntry> cells;  ///< the first is the row's header
  bool muted = false;             ///< no result
};

/// `caption` is plain text. A wide table scrolls within its place.
std::string tableHtml(const std::string& caption, const std::vector<TableColumn>& columns,
                      const std::vector<TableLine>& lines, const std::string& style = "");

/// ` data-technique="..."`; "" for "".
std::string filterAttributes(const std::string& technique, const std::string& backend);

TableEntry textEntry(const std::string& text);  ///< plain text
TableEntry numberEntry(const std::optional<double>& value);
/// What is absent, with the reason on hover and for screen readers.
TableEntry absentEntry(const std::string& why);

}  // namespace report
