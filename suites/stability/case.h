// Hard cases (spec 17): a configuration that is dangerous, a property that must hold, a tolerance
// with its reason. A case builds scenes, renders them by one technique and returns what it found.
#pragma once

#include "reports/stability_record.h"
#include "suites/stability/probe.h"

namespace sb {

/// What a case found, before its verdict.
struct Found {
  std::vector<report::StabilityPoint> curve;
  /// Error by construction that excuses what exceeds the tolerance; empty: nothing does.
  std::string expected;
  /// Why nothing can be asked of this scene, or "".
  std::string leftOut = "";
};

/// A property asked of a scene of the user's.
struct SceneForm {
  Found (*run)(const CaseContext&) = nullptr;  ///< null: it needs the case's own scene
  std::string property;
  std::string reason;
};

/// Whom a case asks: a broken property is the fault of shadows, of camera transparency, of either.
enum class Asks : uint8_t { Shadows, Transparency, Both };

struct StabilityCase {
  std::string id;
  std::string title;
  std::string property;        ///< what must hold, with the unit of values
  std::string reason;          ///< of the tolerance
  std::string parameter = "";  ///< of the curve, with its unit; "": configurations without order
  bool logarithmic = false;
  Asks asks = Asks::Shadows;
  /// Why a technique is not asked, or "": it is.
  std::string (*leavesOut)(const CaseContext&) = nullptr;
  Found (*run)(const CaseContext&) = nullptr;
  SceneForm onScene = {};
};

/// All cases, in the order of spec 17.
const std::vector<StabilityCase>& stabilityCases();

/// Of the generic properties, by their ids.
SceneForm sceneForm(const std::string& id);
/// Pixels of the first opaque surface whose visibility changed although nothing within two pixels
/// varies. Not a number where it varies everywhere.
double changedInside(Probe& before, Probe& after, uint32_t light = kFirstInView);
/// Values of picture and visibility that are not finite, and visibilities outside [0, 1].
double badValues(Probe& probe);

// One file each.
std::vector<StabilityCase> genericCases();       ///< G1-G11
std::vector<StabilityCase> opaqueCases();        ///< rows of spec 01
std::vector<StabilityCase> translucentCases();   ///< rows of specs 02-05: layers and orders
std::vector<StabilityCase> boundaryCases();      ///< rows of specs 01-05: ties, far planes, p of 0 and 1
std::vector<StabilityCase> volumeCases();        ///< rows of spec 07
std::vector<StabilityCase> wedgeCases();         ///< rows of spec 08
std::vector<StabilityCase> wedgeSweepCases();    ///< its curves; H5, H6
std::vector<StabilityCase> concaveCases();      ///< spec 01: surfaces that rise before themselves
std::vector<StabilityCase> transparencyCases();  ///< rows of spec 15
std::vector<StabilityCase> tortureCases();       ///< H2, H3, H4, H7, H8

/// 4 sigma of a mean of n draws that are 1 with probability q (N7).
double fourSigma(double q, double n);
/// What the technique says its error is, when it does not represent `effect`; else "".
std::string missing(const CaseContext& context, Effect effect);

}  // namespace sb
