// Cells of the matrix (reports/cell_id.h) and the techniques that draw them: running a cell depends
// on nothing else, so that it can be handed to another process or machine, and its name reproduces
// it.
#pragma once

#include <cstdint>
#include <string>

#include "reports/cell_id.h"
#include "techniques/render/technique.h"

namespace sb {

using report::CellId;
using report::cellName;
using report::kDefaultLights;
using report::kDefaultTransparency;
using report::kTracerBackend;
using report::techniqueName;

/// Of stochastic techniques, where nothing else is asked for.
inline constexpr uint32_t kDefaultSeeds = 64;

/// The truth's tracer as a row of the comparison, in the words of techniques: on the CPU, whatever
/// the backends.
const TechniqueInfo& referenceInfo();
bool isReference(const CellId& id);
report::Role roleOf(const CellId& id);

/// A cell of which only the techniques are known: those that TECHNIQUE[+TRANSPARENCY][@LIGHTS]
/// names, or the tracer. Throws InputError naming the nearest.
CellId parseTechniques(const std::string& text);

/// What draws a cell. Throws InputError for names that do not exist, so too for the tracer's.
TechniqueSet techniquesOf(const CellId& id);
/// Knobs that the cell's techniques have.
std::vector<KnobInfo> knobInfosOf(const CellId& id);
/// Their values. Throws InputError.
Knobs cellKnobs(const CellId& id);
/// The cell with these values, whatever it had. Throws InputError.
CellId withKnobs(CellId id, const std::map<std::string, std::string>& values);

/// The cell that this one's cost is told against: the same without shadows.
CellId baselineOf(const CellId& id);
/// What a cell has in common with itself on other backends.
CellId onAnyBackend(CellId id);
/// As records and journals have it: their texts are UTF-8, names of files need not be.
CellId recordedId(CellId id);

/// The command line that measures this cell again; `seeds`: over which noise is taken.
std::string cellCommand(const CellId& id, uint32_t seeds = kDefaultSeeds);

}  // namespace sb
