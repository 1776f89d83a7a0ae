// Scenes with media run with every technique: none of today's represents media, which stands in the
// plan, and the frame is that of the scene without.
#include "techniques/render/registry.h"
#include "tests/techniques/recorded.h"

namespace sb::test {
namespace {

bool lacksMedia(const Plan& plan) {
  return std::ranges::find(plan.unrepresented, Effect::ParticipatingMedia) !=
         plan.unrepresented.end();
}

TEST(MediaPlan, WhatNoTechniqueShowsIsSaid) {
  const Scene clear = withPane(opaqueScene());
  Scene misty = clear;
  misty.media.push_back({.name = "mist", .extinction = glm::vec3(1), .albedo = glm::vec3(1)});
  Scene thin = misty;
  thin.media[0].extinction = glm::vec3(1e-6f);
  size_t techniques = 0;
  for (const ShadowEntry* entry : shadowTechniques()) {
    const std::string name(entry->info.name);
    SCOPED_TRACE(name);
    const Recorded with = record(misty, name), without = record(clear, name);
    EXPECT_TRUE(lacksMedia(with.plan));
    EXPECT_FALSE(lacksMedia(without.plan));
    EXPECT_FALSE(lacksMedia(record(thin, name).plan));
    EXPECT_EQ(with.calls, without.calls);
    EXPECT_EQ(with.bytes, without.bytes);
    ++techniques;
  }
  EXPECT_GE(techniques, 5u);
}

}  // namespace
}  // namespace sb::test
