// Lights with an extent driven to where penumbra wedges break (spec 17, rows of 08): receivers at
// edges, edges that point at the light, reach into it or lie on its axis, eyes within penumbrae,
// many edges at once, casters that overlap.
#include "suites/stability/cases/wedge_scenes.h"

namespace sb {
namespace {

Found contact(const CaseContext& context) {
  return worstAlong(context, {0, 1e-6, 1e-4, 1e-2}, [](double gap) {
    Scene scene = lamp();
    addBox(scene, 0, {-0.75f, float(gap), -0.5f}, {0.5f, 0.75f, 0.5f});
    return scene;
  });
}

Found edgeAtLight(const CaseContext& context) {
  // A sheet and walls of a column whose edges point at the light's centre, or nearly: they have
  // their side to it, so that what its other points see of them is not in the silhouette.
  Found found;
  for (const double aside : {0.0, 1e-7, 1e-5, 1e-3}) {
    Scene scene = lamp();
    addQuad(scene, 0, {0.5f, 2, float(aside)}, {0.25f, -1, 0}, {0.125f, -0.5f, 0.25f});
    addBox(scene, 0, {float(aside), 1, -1}, {0.5f, 2, 0});
    Probe probe(context, std::move(scene), {.size = {48, 36}});
    found.curve.push_back({aside, badValues(probe), 0});
  }
  return found;
}

Found edgeThroughCentre(const CaseContext& context) {
  // Seen from the middle column, the light's centre is on an edge or at a corner.
  return worstAlong(context, {-1e-3, -1e-6, 0, 1e-6, 1e-3}, [](double aside) {
    Scene scene = lamp(0.5, {0, 4, 5});
    addHorizontal(scene, 0, {1 + float(aside), 1, 0}, 1, 0.5f);
    return scene;
  });
}

Found eyeInPenumbra(const CaseContext& context) {
  // The eye goes from the light's side of a sheet through the penumbra to the floor.
  return worstAlong(context, {0.1, 0.5, 1.5, 3.5}, [](double height) {
    Scene scene = lamp(0.5, {-1.25, height, 1});
    addHorizontal(scene, 0, {0, 1, 0}, 1, 0.5f);
    return scene;
  });
}

Found manyEdges(const CaseContext& context) {
  return worstAlong(context, {8, 64, 500}, [](double corners) {
    Scene scene = lamp();
    addDisc(scene, {0.125, 1, 0}, 0.25, uint32_t(corners));
    return scene;
  });
}

Found beyondLight(const CaseContext& context) {
  // A wall beside the light that ends so far above its plane, and a lid over it.
  return worstAlong(context, {-1.5, 0, 1, 10}, [](double above) {
    Scene scene = lamp();
    addQuad(scene, 0, {1.5f, float(2.5 + 0.5 * above), 0}, {0, float(1.5 + 0.5 * above), 0},
            {0, 0, 1});
    addHorizontal(scene, 0, {0, 5, 0}, 1, 1);
    return scene;
  });
}

Found overlapping(const CaseContext& context) {
  // Where they overlap, shares add up: darker, not lighter.
  Found found;
  for (const double apart : {2.0, 0.75, 0.25, 0.0}) {
    Scene scene = lamp();
    addHorizontal(scene, 0, {-0.5, 1, 0}, 0.5f, 0.5f);
    addHorizontal(scene, 0, {-0.5 + apart, 1.5, 0.125}, 0.375f, 0.5f);
    found.curve.push_back({apart, shareErrors(context, std::move(scene)).lighter.value(), kTolerance});
  }
  return found;
}

Found reachingIn(const CaseContext& context) {
  // Sheets before, at and in the light, a box around its centre: nothing can be said but that
  // shares are shares.
  Found found;
  for (const double distance : {0.75, 0.5, 0.25, 0.0}) {
    Scene scene = lamp();
    addHorizontal(scene, 0, {0.25, 4 - float(distance), 0}, 0.5f, 0.5f);
    if (distance == 0) addBox(scene, 0, {-0.25f, 3.75f, -0.25f}, {0.25f, 4.25f, 0.25f});
    Probe probe(context, std::move(scene), {.size = {48, 36}});
    found.curve.push_back({distance, badValues(probe), 0});
  }
  return found;
}

}  // namespace

std::vector<StabilityCase> wedgeCases() {
  std::vector<StabilityCase> cases = {
      wedgeCase("penumbra contact", "A box that touches the floor, or nearly", "gap, world units",
                contact),
      wedgeCase("edge at light", "Edges that point at a light's centre", "aside, world units",
                edgeAtLight),
      wedgeCase("edge through centre", "A light's centre on an edge or a corner",
                "aside, world units", edgeThroughCentre),
      wedgeCase("eye in penumbra", "An eye before, in and behind a penumbra", "height of the eye",
                eyeInPenumbra),
      wedgeCase("many edges", "Many edges before a light at once", "edges", manyEdges),
      wedgeCase("beyond light", "Casters that reach beyond a light's plane",
                "above it, world units", beyondLight),
      wedgeCase("overlapping", "Casters that overlap before a light", "apart, world units",
                overlapping),
      wedgeCase("reaching in", "Casters that reach into a light", "distance, world units",
                reachingIn)};
  cases[6].property = kNoLighter;
  for (const size_t i : {1, 7}) {
    cases[i].property = kFiniteShares;
    cases[i].reason = "exact";
  }
  return cases;
}

}  // namespace sb
