// Top of the page: what the reader must know before a figure is believed, then the circumstances.
#include <fmt/format.h>

#include <map>
#include <set>

#include "reports/html/elements/text.h"
#include "reports/html/sections/sections.h"

namespace report {
namespace {

using Names = std::vector<std::string>;

std::string notice(const std::string& style, const std::string& html) {
  return "<li class=\"" + style + "\">" + html + "</li>\n";
}

/// "2 cells failed: REASON", and which on demand.
std::string groupNotice(const std::string& style, const std::string& what,
                        const std::string& reason, const Names& names) {
  std::string out = "<strong>" + counted(names.size(), "cell", "cells") + " " + what +
                    "</strong>: " + escaped(reason) + " <details><summary>which</summary><ul>";
  for (const std::string& name : names) out += "<li><code>" + escaped(name) + "</code></li>";
  return notice(style, out + "</ul></details>");
}

/// The same words of several cells stand once, in order of first appearance.
class Groups {
 public:
  void add(const std::string& reason, const std::string& name) {
    if (!m_names.contains(reason)) m_order.push_back(reason);
    m_names[reason].push_back(name);
  }
  std::string html(const std::string& style, const std::string& what) const {
    std::string out;
    for (const std::string& reason : m_order)
      out += groupNotice(style, what, reason, m_names.at(reason));
    return out;
  }

 private:
  Names m_order;
  std::map<std::string, Names> m_names;
};

std::string notices(const PageModel& model, const Names& notes) {
  const Run& run = model.run;
  std::string out;
  Groups contaminated, failed, skipped, warned;
  bool software = false, wall = false, validated = false;
  for (const Record& r : run.records) {
    software |= r.timeSource == "software";
    wall |= r.timeSource == "wall";
    for (const std::string& c : r.contamination) {
      contaminated.add(c, r.name);
      validated |= c.find("validation") != std::string::npos;
    }
    for (const std::string& w : r.warnings) warned.add(w, r.name);
    if (r.status == Status::Failed) failed.add(r.reason, r.name);
    if (r.status == Status::Skipped) skipped.add(r.reason, r.name);
  }
  if (software)
    out += notice("serious",
                  "<strong>Software devices.</strong> These figures say nothing about graphics "
                  "hardware: frame times are wall times, and cells are compared by the CPU time of "
                  "all threads.");
  if (wall)
    out += notice("serious",
                  "<strong>A device has no timestamps.</strong> Its frame times are wall "
                  "times to completion.");
  if (run.buildType == "debug")
    out += notice("serious", "<strong>Debug build.</strong> The times are of no use.");
  if (validated)
    out += notice("serious",
                  "<strong>Validation was on.</strong> It costs time; such cells are in "
                  "no ratio and no plot.");
  if (run.records.empty() && run.stability.empty())
    out += notice("serious", "<strong>The run has no cells.</strong>");
  out += failed.html("serious", "failed");
  out += contaminated.html("serious", "contaminated, in no ratio and no plot");
  out += skipped.html("mild", "skipped");
  for (const std::string& w : run.warnings) out += notice("mild", escaped(w));
  out += warned.html("mild", "with a warning");
  for (const std::string& note : notes) out += notice("mild", escaped(note));
  return out.empty()
             ? ""
             : "<h2 class=\"unseen\">Warnings</h2>\n<ul class=\"notices\">\n" + out + "</ul>\n";
}

void fact(std::string& out, const std::string& name, const std::string& html) {
  if (!html.empty()) out += "<div><dt>" + name + "</dt><dd>" + html + "</dd></div>\n";
}

std::string list(const std::set<std::string>& items) {
  std::string out;
  for (const std::string& item : items) out += (out.empty() ? "" : "<br>") + item;
  return out;
}

std::string machine(const Run& run) {
  std::string out = escaped(run.host);
  if (run.cpus > 0) out += ", " + counted(run.cpus, "CPU", "CPUs");
  if (run.cpuMHz > 0) out += fmt::format(" at {:.0f} MHz", run.cpuMHz);
  if (run.cpuScaling) out += " (clock may change)";
  if (!run.loadAverage.empty()) out += ", load " + figure(run.loadAverage.front());
  return out;
}

std::string facts(const PageModel& model) {
  const Run& run = model.run;
  std::set<std::string> devices, sizes, seeds;
  size_t ok = 0, byBudget = 0;
  for (const Record& r : run.records) {
    if (!r.device.empty())
      devices.insert(model.backendHtml(r.id.backend) + " " + escaped(r.device) + " (" +
                     escaped(r.deviceType) + "), driver " + escaped(r.driver));
    sizes.insert(fmt::format("{}×{}", r.id.width, r.id.height));
    seeds.insert(std::to_string(r.id.seed));
    ok += r.status == Status::Ok;
    byBudget += r.stoppedBy == "budget";
  }
  std::string out = "<dl class=\"facts\">\n";
  fact(out, "Devices", list(devices));
  fact(out, "Machine", machine(run));
  if (!run.records.empty())
    fact(out, "Cells",
         fmt::format("{} of {} measured", ok, run.records.size()) +
             (byBudget ? fmt::format("; {} stopped by the budget before the precision asked for",
                                     byBudget)
                       : ""));
  fact(out, sizes.size() == 1 ? "Size" : "Sizes", list(sizes));
  fact(out, seeds.size() == 1 ? "Seed" : "Seeds", list(seeds));
  fact(out, "Version",
       "ShadowBench " + escaped(run.version) +
           (run.buildType.empty() ? "" : ", " + escaped(run.buildType) + " build"));
  fact(out, "Date", escaped(run.date));
  return out + "</dl>\n";
}

/// One checkbox; the script reads what is checked.
std::string choice(const std::string& name, const std::string& value, const std::string& html) {
  return "<label><input type=\"checkbox\" name=\"" + name + "\" value=\"" + escaped(value) +
         "\" checked>" + html + "</label>\n";
}

}  // namespace

std::string overviewHtml(const PageModel& model, const Names& notes) {
  std::string out =
      "<p class=\"eyebrow\">ShadowBench report</p>\n<h1>What shadows cost, and how wrong they "
      "are</h1>\n" +
      notices(model, notes) + facts(model) + "<nav aria-label=\"Parts\"><ul>\n";
  for (size_t i = 0; i < model.run.figures.size(); ++i)
    out += "<li><a href=\"#figure" + std::to_string(i) + "\">Figure " +
           escaped(model.run.figures[i].id) + "</a></li>\n";
  if (!model.run.stability.empty()) out += "<li><a href=\"#stability\">Hard cases</a></li>\n";
  for (const ScenePart& part : model.parts)
    out += "<li data-scene=\"" + escaped(part.scene) + "\"><a href=\"#" + part.id + "\">" +
           escaped(part.title()) + "</a></li>\n";
  return out + "</ul></nav>";
}

std::string filtersHtml(const PageModel& model) {
  const std::string noCells = model.run.records.empty() ? " hidden" : "";
  std::string out =
      "<form class=\"filters\" id=\"filters\" aria-label=\"What is shown\" hidden>\n"
      "<fieldset><legend>Technique</legend>\n";
  for (const std::string& t : model.techniques)
    out += choice("technique", t, model.techniqueHtml(t));
  out += "</fieldset>\n<fieldset><legend>Backend</legend>\n";
  for (const std::string& b : model.backends) out += choice("backend", b, model.backendHtml(b));
  out +=
      "</fieldset>\n<fieldset" + noCells + "><legend>Error</legend>\n"
      "<label><input type=\"radio\" name=\"kind\" value=\"visibility\" checked>visibility</label>\n"
      "<label><input type=\"radio\" name=\"kind\" value=\"image\">image</label>\n</fieldset>\n"
      "<label class=\"scene-choice\"" + noCells + ">Scene <select name=\"scene\"><option value=\"\">all</option>";
  for (const std::string& s : model.scenes)
    out += "<option value=\"" + escaped(s) + "\">" + escaped(s) + "</option>";
  return out +
         "</select></label>\n<button type=\"reset\">Show all</button>\n"
         "<output id=\"shown\"" + noCells + " aria-live=\"polite\"></output>\n</form>";
}

}  // namespace report
