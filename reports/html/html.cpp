#include "reports/html/html.h"

#include <cassert>
#include <map>

#include "reports/html/elements/text.h"
#include "reports/html/embed/assets.h"
#include "reports/html/sections/sections.h"

namespace report {
namespace {

/// No network at all, and no script but the two of this page, by their hashes: text that slipped
/// through the escaping would still not run. Vega's interpreter makes unsafe-eval needless. Styles
/// may be inline: bars have their widths there, and styles can load nothing here.
std::string policy() {
  std::string out = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src";
  for (const char* hash : {"library.js.sha256", "page.js.sha256"})
    out += " 'sha256-" + base64OfHex(asset(hash)) + "'";
  return out + "; base-uri 'none'; form-action 'none'";
}

/// Replaces {{name}}; what is put in is not looked at again.
std::string filled(std::string_view page, const std::map<std::string, std::string_view>& values) {
  std::string out;
  for (size_t at = 0; at < page.size();) {
    const size_t open = page.find("{{", at);
    if (open == std::string_view::npos) return out += page.substr(at);
    const size_t close = page.find("}}", open);
    out += page.substr(at, open - at);
    const auto value = values.find(std::string(page.substr(open + 2, close - open - 2)));
    assert(value != values.end());
    out += value->second;
    at = close + 2;
  }
  return out;
}

std::string title(const Run& run) {
  return "ShadowBench " + run.version + (run.date.empty() ? "" : ", " + run.date);
}

}  // namespace

std::filesystem::path journalBeside(const std::filesystem::path& json) {
  return std::filesystem::path(json).replace_extension(".journal");
}

std::filesystem::path picturesBeside(const std::filesystem::path& json) {
  std::filesystem::path out = json;
  return out.replace_extension(".pictures");
}

std::string toHtml(const Run& run, const HtmlSettings& settings) {
  const PageModel model(run);
  PictureSet pictures(settings.pictures);
  CurveSet curves;
  std::string scenes = figuresHtml(model, pictures, curves);
  scenes += summaryHtml(model);
  scenes += stabilityHtml(model, curves);
  for (const ScenePart& part : model.parts) scenes += sceneHtml(model, part, settings, pictures);
  // Notes and data know only now which pictures there are.
  const std::string overview = overviewHtml(model, pictures.notes());
  const std::string filters = filtersHtml(model), data = pageData(model, pictures, curves);
  const std::string name = escaped(title(run)), rules = policy();
  const std::string footer =
      "<p>Written by ShadowBench " + escaped(run.version) +
      ". Times are medians; intervals are 95&nbsp;%. Error is measured minus truth, in linear "
      "values. Plots are drawn by Vega; its licence stands in this file.</p>";
  return filled(asset("page.html"), {{"policy", rules},
                                     {"title", name},
                                     {"style", asset("page.css")},
                                     {"overview", overview},
                                     {"filters", filters},
                                     {"scenes", scenes},
                                     {"footer", footer},
                                     {"data", data},
                                     {"library", asset("library.js")},
                                     {"script", asset("page.js")}});
}

}  // namespace report
