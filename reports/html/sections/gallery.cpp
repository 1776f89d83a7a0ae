// Pictures of a scene: the truth once, then for each cell its picture, where it is wrong, and why.
#include <fmt/format.h>

#include <algorithm>

#include "reports/html/elements/text.h"
#include "reports/html/sections/sections.h"

namespace report {
namespace {

std::string css(const Rgb8& c) { return fmt::format("rgb({},{},{})", c[0], c[1], c[2]); }

std::string colorOf(const HtmlSettings& settings, const std::string& cause) {
  for (const auto& [name, color] : settings.causeColors)
    if (name == cause) return css(color);
  return "";
}

std::string swatch(const std::string& color) {
  return color.empty() ? "" : "<span class=\"swatch\" style=\"background:" + color + "\"></span>";
}

/// What each cause means, for who sees its name first here.
const std::pair<const char*, const char*> kCauses[] = {
    {"noise", "differs from seed to seed"},
    {"resolution", "a shadow edge, or a surface's edge, within the lookup's reach"},
    {"inner-layer", "elsewhere, on a translucent receiver"},
    {"self-shadowing", "elsewhere, darker than the truth"},
    {"leaking", "elsewhere, lighter than the truth"}};

std::string legends(const HtmlSettings& s) {
  const std::string least = s.errorLeast == 1.0 / 1024 ? "1/1024" : figure(s.errorLeast);
  std::string out =
      "<div class=\"legends\">\n<p class=\"scale-legend\">Error map: largest channel, ";
  if (s.errorScale.empty()) {
    out += "from dark (" + least + ") to bright (" + figure(s.errorMost) + "), logarithmic";
  } else {
    out += "logarithmic <span class=\"ends\">" + least +
           "</span><span class=\"scale\" style=\"background:linear-gradient(to right";
    for (const Rgb8& c : s.errorScale) out += "," + css(c);
    out += ")\"></span><span class=\"ends\">" + figure(s.errorMost) + "</span>";
  }
  out +=
      "</p>\n<dl class=\"cause-legend\"><div><dt class=\"what\">Blame map</dt> "
      "<dd>largest cause of the squared error</dd></div>";
  for (const auto& [name, meaning] : kCauses)
    out += "<div><dt>" + swatch(colorOf(s, name)) + name + "</dt> <dd>" + meaning + "</dd></div>";
  return out + "</dl>\n</div>\n";
}

std::string shares(const Record& r, const HtmlSettings& s) {
  if (!r.blame) {
    const std::string why = whyOf(r, "blame");
    return why.empty() ? "" : "<p class=\"shares\">No blame: " + escaped(why) + "</p>";
  }
  if (r.blame->shares.empty()) return "<p class=\"shares\">No error to blame.</p>";
  std::string bar, words;
  for (const auto& [cause, share] : r.blame->shares) {
    const std::string color = colorOf(s, cause);
    if (share <= 0) continue;
    bar += fmt::format("<span style=\"width:{:.2f}%{}\"></span>", 100 * share,
                       color.empty() ? "" : ";background:" + color);
    words += "<span class=\"share\">" + swatch(color) + escaped(cause) + " " +
             fmt::format("{:.0f} %", 100 * share) + "</span> ";
  }
  return "<div class=\"shares\"><span class=\"bar\" aria-hidden=\"true\">" + bar + "</span>" +
         words + "</div>";
}

std::string figureHtml(const std::string& picture, const std::string& caption) {
  return "<figure>" + picture + "<figcaption>" + caption + "</figcaption></figure>\n";
}

/// One card for the backends that gave the very same pictures.
std::string card(const PageModel& model, const std::vector<const Record*>& same,
                 const HtmlSettings& settings, PictureSet& pictures) {
  const Record& r = *same.front();
  const std::string variant = variantOf(r.id);
  std::string backends, label = techniqueOf(r);
  Json names = Json::array();
  for (const Record* other : same) {
    backends += " " + model.backendHtml(other->id.backend);
    label += ", " + other->id.backend;
    names.push_back(other->id.backend);
  }
  if (!variant.empty()) label += ", " + variant;
  std::string out =
      "<article class=\"card\"" + filterAttributes(techniqueOf(r), "") + " data-backends=\"" +
      escaped(names.dump(-1, ' ', true, Json::error_handler_t::replace)) + "\" data-cell=\"" +
      std::to_string(model.indexOf(r)) + "\">\n<h4>" + model.techniqueHtml(techniqueOf(r)) +
      backends + (variant.empty() ? "" : " <small>" + escaped(variant) + "</small>") +
      "</h4>\n<div class=\"pictures\">\n";
  out += figureHtml(pictures.html(r, "image", "Picture of " + label),
                    r.image ? "image, RMSE " + figure(r.image->all.rmse) : "image");
  out += figureHtml(pictures.html(r, "error", "Error map of " + label),
                    r.visibility ? "error, visibility RMSE " + figure(r.visibility->all.rmse) +
                                       (belowTruth(r) ? ", below the truth's resolution" : "")
                                 : "error");
  out += figureHtml(pictures.html(r, "blame", "Blame map of " + label), "blame");
  return out + "</div>\n" + shares(r, settings) + "</article>\n";
}

}  // namespace

std::string galleryHtml(const PageModel& model, const ScenePart& part, const HtmlSettings& settings,
                        PictureSet& pictures) {
  std::string cards, truths;
  std::vector<std::string> seen;
  std::vector<std::vector<const Record*>> groups;
  for (size_t index : part.cells) {
    const Record& r = model.run.records[index];
    if (r.pictures.empty()) continue;
    const auto truth = r.pictures.find("truth");
    if (truth != r.pictures.end() && !std::ranges::count(seen, truth->second)) {
      seen.push_back(truth->second);
      std::string caption = "truth, ray-traced";
      if (r.truthStderr)
        caption += *r.truthStderr == 0 ? ", exact" : ", standard error " + figure(*r.truthStderr);
      truths += "<article class=\"card truth\"><h4>Truth</h4><div class=\"pictures\">" +
                figureHtml(pictures.html(r, "truth", "Truth of " + part.title()), caption) +
                "</div></article>\n";
    }
    const auto group = std::ranges::find_if(groups, [&](const auto& g) {
      return techniqueOf(*g.front()) == techniqueOf(r) &&
             variantOf(g.front()->id) == variantOf(r.id) && g.front()->pictures == r.pictures;
    });
    if (group == groups.end())
      groups.push_back({&r});
    else
      group->push_back(&r);
  }
  for (const auto& group : groups) cards += card(model, group, settings, pictures);
  if (cards.empty()) return "";
  return "<h3>Pictures</h3>\n" + legends(settings) + "<div class=\"gallery\">\n" + truths + cards +
         "</div>\n";
}

}  // namespace report
