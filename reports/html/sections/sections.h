// The parts of the page. Each gives HTML that stands without scripts; text from files is escaped.
#pragma once

#include <string>

#include "reports/html/elements/curve_set.h"
#include "reports/html/elements/picture_set.h"
#include "reports/html/elements/table.h"
#include "reports/html/html.h"
#include "reports/html/model.h"

namespace report {

/// Warnings first, then where and with what the run was made. `notes` are the pictures'.
std::string overviewHtml(const PageModel& model, const std::vector<std::string>& notes);
/// Techniques, backends, scenes and the kind of error to show; for the script, hidden without it.
std::string filtersHtml(const PageModel& model);

/// What one time buys in every scene; "" for a single scene.
std::string summaryHtml(const PageModel& model);
/// Figures of the suite's document, each with its verdicts; "" without any.
std::string figuresHtml(const PageModel& model, PictureSet& pictures, CurveSet& curves);
/// Hard cases: verdicts and curves; "" without any.
std::string stabilityHtml(const PageModel& model, CurveSet& curves);
/// One scene: plot, tables, bars, pictures.
std::string sceneHtml(const PageModel& model, const ScenePart& part, const HtmlSettings& settings,
                      PictureSet& pictures);
/// All cells of a scene with their figures: the text alternative of the plot.
std::string cellTable(const PageModel& model, const ScenePart& part);
/// Best error within a time, least time within an error, orders of convergence, exchange rates.
std::string tradeTables(const PageModel& model, const ScenePart& part, ErrorKind kind);
std::string passBars(const PageModel& model, const ScenePart& part);
std::string backendRatios(const PageModel& model, const ScenePart& part);
std::string memoryBars(const PageModel& model, const ScenePart& part);
std::string stochasticTable(const PageModel& model, const ScenePart& part);
std::string galleryHtml(const PageModel& model, const ScenePart& part, const HtmlSettings& settings,
                        PictureSet& pictures);

/// What plots and details are made from, for the script.
std::string pageData(const PageModel& model, const PictureSet& pictures, const CurveSet& curves);

/// The cell's point among the trade-offs; null when it has none.
const TradePoint* pointOf(const std::vector<const TradeOff*>& tradeOffs, const Record& record);
/// A line that goes with the filters of a cell, its first cells filled: technique, backend, knobs.
TableLine cellLine(const PageModel& model, const Record& record);
/// The columns that cellLine fills.
std::vector<TableColumn> cellColumns();

}  // namespace report
