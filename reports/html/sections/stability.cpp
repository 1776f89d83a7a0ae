// Hard cases: one table technique x case, and a curve for each case with a dangerous parameter.
// A verdict is a word and a mark of its own shape, so that it does not hang on colour.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "reports/html/elements/text.h"
#include "reports/html/sections/sections.h"

namespace report {
namespace {

using Cases = std::vector<const StabilityRecord*>;

struct Look {
  const char *style, *mark;
};

Look lookOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::Pass:
      return {"holds", "✓"};
    case Verdict::Expected:
      return {"expected", "◇"};
    case Verdict::Fail:
      return {"fails", "✕"};
    case Verdict::Skipped:
      break;
  }
  return {"unasked", "–"};
}

std::string verdictHtml(Verdict verdict) {
  const Look look = lookOf(verdict);
  return fmt::format("<span class=\"verdict {}\"><span aria-hidden=\"true\">{}</span> {}</span>",
                     look.style, look.mark, verdictName(verdict));
}

int rank(Verdict v) {
  return v == Verdict::Fail ? 3 : v == Verdict::Expected ? 2 : v == Verdict::Pass ? 1 : 0;
}

void term(std::string& out, const std::string& name, const std::string& html) {
  if (!html.empty()) out += "<dt>" + name + "</dt><dd>" + html + "</dd>";
}

std::string parameterText(const StabilityRecord& r, double x) {
  return escaped(r.parameter) + " " + figure(x);
}

std::string detail(const PageModel& model, const StabilityRecord& r) {
  std::string out =
      "<h5>" + model.backendHtml(r.backend) + " " + verdictHtml(r.verdict) + "</h5>\n<dl>";
  term(out, "must hold", escaped(r.property));
  if (const StabilityPoint* p = r.worst()) {
    const bool numeric = !r.parameter.empty();
    term(out, "found",
         (std::isfinite(p->value) ? figure(p->value) : "no number") +
             (numeric ? " at " + parameterText(r, p->x) : ""));
    term(out, "allowed", figure(p->tolerance) + ": " + escaped(r.reason));
    if (numeric)
      term(out, "breaks at", r.breaksAt ? parameterText(r, *r.breaksAt) : "nowhere in range");
  }
  term(out, "why", escaped(r.why));
  return out + "</dl>\n";
}

/// The worst verdict of a technique's APIs; how many share it, when not all do; the rest on demand.
TableEntry entry(const PageModel& model, const Cases& of, const std::string& technique) {
  if (of.empty())
    return {.html = "<span class=\"unseen\">not asked</span>", .technique = technique};
  const StabilityRecord* worst =
      *std::ranges::max_element(of, {}, [](const StabilityRecord* r) { return rank(r->verdict); });
  const auto same = std::ranges::count(of, worst->verdict, &StabilityRecord::verdict);
  std::string head = verdictHtml(worst->verdict);
  if (same != std::ssize(of)) head += fmt::format(" {}/{}", same, of.size());
  std::string out = "<details><summary>" + head + "</summary>\n";
  for (const StabilityRecord* r : of) out += detail(model, *r);
  return {.html = out + "</details>", .value = rank(worst->verdict), .technique = technique};
}

/// Values that leave 0 and span magnitudes need an axis that does too.
bool isWide(const Cases& of) {
  double most = 0, least = INFINITY;
  for (const StabilityRecord* r : of)
    for (const StabilityPoint& p : r->curve)
      for (const double v : {p.value, p.tolerance})
        if (std::isfinite(v) && v > 0) most = std::max(most, v), least = std::min(least, v);
  return most > 50 * least;
}

std::string curveHtml(const PageModel& model, const Cases& of, CurveSet& curves) {
  const StabilityRecord& first = *of.front();
  Curve curve{.xTitle = first.parameter,
              .yTitle = "found",
              .logarithmicX = first.logarithmic,
              .wideY = isWide(of),
              .lines = {}};
  std::string breaks;
  for (const StabilityRecord* r : of) {
    CurveLine line{
        .technique = r->technique, .backend = r->backend, .points = {}, .breaksAt = r->breaksAt};
    for (const StabilityPoint& p : r->curve) {
      line.points.push_back({p.x, p.value});
      line.limit.push_back({p.x, p.tolerance});
    }
    curve.lines.push_back(std::move(line));
    if (r->breaksAt)
      breaks += "<li" + filterAttributes(r->technique, r->backend) + ">" +
                model.techniqueHtml(r->technique) + " " + model.backendHtml(r->backend) +
                " breaks at " + figure(*r->breaksAt) + "</li>";
  }
  const std::string caption = "<strong>" + escaped(caseLabel(first, model.run.stability)) + "</strong> " + escaped(first.title) +
                              ": " + escaped(first.property) +
                              (breaks.empty() ? "<br>Nothing breaks in this range."
                                              : "<ul class=\"breaks\">" + breaks + "</ul>");
  return curves.html(std::move(curve), caption);
}

std::string totals(const std::vector<StabilityRecord>& all) {
  std::map<Verdict, size_t> n;
  for (const StabilityRecord& r : all) ++n[r.verdict];
  return fmt::format(
      "<p>{} hard cases: {} {}, {} {} (break as their construction says), {} {}, {} "
      "{}.</p>\n",
      all.size(), n[Verdict::Pass], verdictHtml(Verdict::Pass), n[Verdict::Expected],
      verdictHtml(Verdict::Expected), n[Verdict::Fail], verdictHtml(Verdict::Fail),
      n[Verdict::Skipped], verdictHtml(Verdict::Skipped));
}

/// Whose picture the properties were asked of, when not of the cases' own.
std::string askedScenes(const std::vector<StabilityRecord>& all) {
  std::set<std::string> scenes;
  for (const StabilityRecord& r : all)
    if (!r.scene.empty())
      scenes.insert(escaped(r.scene) + fmt::format(", {}×{}", r.width, r.height));
  std::string out;
  for (const std::string& scene : scenes) out += (out.empty() ? "" : "; ") + scene;
  return out.empty() ? "" : "<p>Asked of " + out + ".</p>\n";
}

}  // namespace

std::string stabilityHtml(const PageModel& model, CurveSet& curves) {
  const auto& all = model.run.stability;
  if (all.empty()) return "";
  std::vector<std::string> techniques, ids;
  std::map<std::string, Cases> byCase;
  for (const StabilityRecord& r : all) {
    if (!std::ranges::count(techniques, r.technique)) techniques.push_back(r.technique);
    const std::string label = caseLabel(r, all);
    if (!byCase.contains(label)) ids.push_back(label);
    byCase[label].push_back(&r);
  }
  std::vector<TableColumn> columns = {{"Hard case"}};
  for (const std::string& t : techniques) columns.push_back({t, false, "", t});
  std::vector<TableLine> lines;
  std::string plots;
  for (const std::string& id : ids) {
    const Cases& of = byCase[id];
    TableLine line{
        .cells = {{.html = escaped(id) + "<small>" + escaped(of.front()->title) + "</small>"}}};
    Cases drawn;
    for (const std::string& t : techniques) {
      Cases cell;
      for (const StabilityRecord* r : of)
        if (r->technique == t) cell.push_back(r);
      line.cells.push_back(entry(model, cell, t));
      for (const StabilityRecord* r : cell)
        if (!r->parameter.empty() && r->curve.size() > 1) drawn.push_back(r);
    }
    lines.push_back(std::move(line));
    if (!drawn.empty()) plots += curveHtml(model, drawn, curves);
  }
  std::string out =
      "<section class=\"stability\" id=\"stability\" aria-labelledby=\"stability-title\">\n"
      "<h2 id=\"stability-title\">Hard cases</h2>\n" +
      totals(all) + askedScenes(all) +
      tableHtml("Verdicts, the worst of all APIs; press one for what was found and allowed",
                columns, lines, "verdicts");
  if (!plots.empty())
    out +=
        "<h3 class=\"scripted-only\">Where it breaks</h3>\n<p class=\"scripted-only\">What was "
        "found over the dangerous parameter; broken grey lines are what is allowed, a cross is the "
        "first point beyond it.</p>\n<div class=\"curves\">\n" +
        plots + "</div>\n";
  return out + "</section>\n";
}

}  // namespace report
