// One scene of the page: plot with details, trade-offs, cells, costs, pictures.
#include "reports/html/elements/text.h"
#include "reports/html/sections/sections.h"

namespace report {
namespace {

bool hasPoints(const ScenePart& part) {
  for (const auto* all : {&part.visibility, &part.image})
    for (const TradeOff* t : *all)
      if (!t->points.empty()) return true;
  return false;
}

/// Why there is no plot, in the records' own words.
std::string noPlot(const PageModel& model, const ScenePart& part) {
  std::string why;
  for (size_t index : part.cells) {
    const Record& r = model.run.records[index];
    if (why.empty() && r.status == Status::Ok) why = whyOf(r, "visibility");
  }
  return "<p class=\"notice\">No plot of error over time: " +
         (why.empty() ? "no cell has both a time that counts and an error against the truth"
                      : escaped(why)) +
         ".</p>\n";
}

/// The script draws into it; the table of all cells says the same in words.
std::string plot(const ScenePart& part) {
  return "<div class=\"plot-and-details\">\n<figure class=\"plot\" hidden>\n<div class=\"canvas\" "
         "data-part=\"" +
         part.id + "\"></div>\n<figcaption>" + escaped(part.timeName()) +
         " and RMSE with their 95&nbsp;% intervals; lower left is better. "
         "<span class=\"mark-key front\"></span>&nbsp;on the Pareto front, "
         "<span class=\"mark-key uncertain\"></span>&nbsp;on it, but within the intervals another "
         "cell may be better, <span class=\"mark-key off\"></span>&nbsp;off the front. The front "
         "is "
         "that of all cells of one backend, whatever is filtered out. Arrow keys go from point to "
         "point; the figures stand in the table <a href=\"#" +
         part.id +
         "-cells\">All cells</a>.</figcaption>\n</figure>\n<aside class=\"details\" hidden "
         "aria-label=\"Cell\"></aside>\n</div>\n";
}

std::string under(const std::string& title, const std::string& html) {
  return html.empty() ? "" : "<h3>" + title + "</h3>\n" + html;
}

}  // namespace

std::string sceneHtml(const PageModel& model, const ScenePart& part, const HtmlSettings& settings,
                      PictureSet& pictures) {
  std::string out = "<section class=\"scene\" id=\"" + part.id + "\" data-scene=\"" +
                    escaped(part.scene) + "\" aria-labelledby=\"" + part.id +
                    "-title\">\n<h2 id=\"" + part.id + "-title\">" + escaped(part.title()) +
                    "</h2>\n";
  out += hasPoints(part) ? "<h3>Error over time</h3>\n" + plot(part) : noPlot(model, part);
  out += under(
      "What a time buys, what an error costs",
      tradeTables(model, part, ErrorKind::Visibility) + tradeTables(model, part, ErrorKind::Image));
  out += "<h3 id=\"" + part.id + "-cells\">All cells</h3>\n" + cellTable(model, part);
  out += under("Noise and certificate", stochasticTable(model, part));
  out += under("Time of each pass", passBars(model, part));
  out += under("One API against the other", backendRatios(model, part));
  out += under("Memory", memoryBars(model, part));
  out += galleryHtml(model, part, settings, pictures);
  return out + "</section>\n";
}

}  // namespace report
