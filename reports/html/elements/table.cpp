#include "reports/html/elements/table.h"

#include <fmt/format.h>

#include "reports/html/elements/text.h"

namespace report {
namespace {

std::string header(const TableColumn& c) {
  std::string out = "<th scope=\"col\"";
  if (c.number) out += " class=\"number\"";
  if (!c.hint.empty()) out += " title=\"" + escaped(c.hint) + "\"";
  return out + filterAttributes(c.technique, "") + ">" + escaped(c.title) + "</th>";
}

std::string cell(const TableEntry& e, const TableColumn& column, bool first) {
  std::string out = first ? "<th scope=\"row\"" : "<td";
  if (column.number) out += " class=\"number\" data-label=\"" + escaped(column.title) + "\"";
  if (e.value) out += fmt::format(" data-value=\"{}\"", *e.value);
  out += filterAttributes(e.technique, "") + ">" + e.html;
  return out + (first ? "</th>" : "</td>");
}

}  // namespace

std::string filterAttributes(const std::string& technique, const std::string& backend) {
  std::string out;
  if (!technique.empty()) out += " data-technique=\"" + escaped(technique) + "\"";
  if (!backend.empty()) out += " data-backend=\"" + escaped(backend) + "\"";
  return out;
}

std::string tableHtml(const std::string& caption, const std::vector<TableColumn>& columns,
                      const std::vector<TableLine>& lines, const std::string& style) {
  std::string out = "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"" +
                    escaped(caption) + "\">\n<table class=\"sortable " + style +
                    "\">\n<caption><span>" + escaped(caption) + "</span></caption>\n<thead><tr>";
  for (const TableColumn& c : columns) out += header(c);
  out += "</tr></thead>\n<tbody>\n";
  for (const TableLine& line : lines) {
    out += "<tr" + filterAttributes(line.technique, line.backend) +
           (line.muted ? " class=\"muted\"" : "") + ">";
    for (size_t i = 0; i < line.cells.size(); ++i) out += cell(line.cells[i], columns[i], i == 0);
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table>\n</div>\n";
}

TableEntry textEntry(const std::string& text) { return {.html = escaped(text)}; }

TableEntry numberEntry(const std::optional<double>& value) {
  return {.html = figure(value), .value = value};
}

TableEntry absentEntry(const std::string& why) {
  if (why.empty()) return {.html = "–"};
  return {.html = "<span title=\"" + escaped(why) + "\">–<span class=\"unseen\"> " + escaped(why) +
                  "</span></span>"};
}

}  // namespace report
