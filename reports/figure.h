// A figure or table of a document that a suite shows again: which cells it is made of, what the
// document says about it, and how to check that against what was measured. Plain data, kept with
// the run, so that a report needs no suite.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace report {

enum class FigureKind : uint8_t {
  Scaling,    ///< times over a parameter
  Pictures,   ///< beside the truth
  Layers,     ///< error by layer of surfaces, and pictures
  Regions,    ///< error and noise by region, and pictures
  Resources,  ///< passes, attachments and memory beside what the document states
};
inline constexpr FigureKind kFigureKinds[] = {FigureKind::Scaling, FigureKind::Pictures,
                                              FigureKind::Layers, FigureKind::Regions,
                                              FigureKind::Resources};
std::string_view figureKindName(FigureKind kind);  ///< "scaling", ...

/// One side of a comparison: a measure over the cells whose names match.
struct FigureSide {
  std::string cells;         ///< regular expression; of the right side "": the left one's
  std::string measure;       ///< reports/figures/measure.h
  std::optional<double> at;  ///< only cells with this x
};

/// A claim of the document, in our words, as a comparison that holds or does not.
struct FigureStatement {
  std::string text;
  /// "value": mean over the cells; "slope", "intercept": of the measure over x; "each": every
  /// cell's left measure against its own right one.
  std::string of = "value";
  FigureSide left, right;
  std::optional<double> number;  ///< instead of the right side
  std::string relation;          ///< "less", "more", "about"
  double factor = 1;             ///< by at least (less, more), within (about)
  std::string otherwise;         ///< why it is not reproduced, when it is not
};

/// What the document states about the resources of cells.
struct FigureStated {
  std::string cells;  ///< regular expression
  std::string passes, attachments, bytes;
};

/// A cell of a figure, measured or not.
struct FigureCell {
  std::string name;
  std::string backend;  ///< "": not known, of what an old file lacks
  bool operator==(const FigureCell&) const = default;
};

struct Figure {
  std::string id;  ///< "5.3.A-D"
  std::string title;
  FigureKind kind = FigureKind::Pictures;
  std::vector<FigureCell> cells;   ///< all that belong to it, measured or not
  std::string x;                   ///< parameter of the scene or knob; of scaling
  double xFallback = 0;            ///< where a cell's name leaves it out
  std::string document;            ///< what the document shows and says, in our words
  std::vector<FigureStatement> statements;
  std::vector<FigureStated> stated;
};

}  // namespace report
