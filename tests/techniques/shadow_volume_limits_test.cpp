// What settings of stencil shadow volumes break by construction, and where (spec 07, spec 17).
#include "tests/techniques/shadow_volume_scenes.h"

using namespace sb;
using namespace sb::test;

GPU_TEST(ShadowVolumes, WhatSettingsBreakIsWhatTheySay) {
  // Counting before the receiver, with the eye in a volume.
  Cell pass(cellDevice(device()), eyeInShadow(), volumes({{"count", "zpass"}}));
  EXPECT_GT(shadowMismatch(pass).elsewhere, 500u);
  // One side of an open mesh: a sheet with its back to the light.
  Scene sheet = floorScene(false);
  addHorizontal(sheet, 0, {0, 1, 0}, 1, 1);
  addLight(sheet, sun({0, -1, 0}));
  const auto dark = [&](const Scene& scene, Setting knobs) {
    Cell cell(cellDevice(device()), scene, volumes(std::move(knobs), {40, 40}));
    return shadowMismatch(cell);
  };
  EXPECT_EQ(dark(sheet, {}).elsewhere, 0u);
  EXPECT_EQ(dark(sheet, {{"casts", "light"}}).elsewhere, 0u);
  EXPECT_GT(dark(sheet, {{"casts", "back"}}).elsewhere, 20u);
  // A lamp in a box: no triangle faces outward to it.
  Scene lamp = floorScene(false);
  addBox(lamp, 0, {-1, 1, -1}, {1, 3, 1});
  addLight(lamp, pointLight({0, 2, 0}, 10));
  EXPECT_EQ(dark(lamp, {}).elsewhere, 0u);
  EXPECT_EQ(dark(lamp, {{"casts", "back"}}).elsewhere, 0u);
  EXPECT_GT(dark(lamp, {{"casts", "light"}}).elsewhere, 500u);
}

GPU_TEST(ShadowVolumes, CountersWrapWhereTheySay) {
  for (const uint32_t layers : {255u, 256u, 257u, 512u}) {
    Scene scene = floorScene();
    Mesh sheets = quadMesh(0, {0, 1, 0}, {1, 0, 0}, {0, 0, -1});
    for (uint32_t i = 1; i < layers; ++i) {
      const auto first = uint32_t(sheets.positions.size());
      for (uint32_t c = 0; c < 4; ++c) {
        sheets.positions.push_back(sheets.positions[c] + glm::vec3(0, float(i) / 256, 0));
        sheets.normals.push_back(sheets.normals[c]);
      }
      for (uint32_t c = 0; c < 6; ++c) sheets.indices.push_back(sheets.indices[c] + first);
      for (uint32_t c = 0; c < 2; ++c) sheets.triangleKeys.push_back(2 * i + c);
    }
    sheets.uv0.clear();
    sheets.boundsMax.y = 4;
    place(scene, add(scene, sheets));
    for (const char* counter : {"stencil8", "float"}) {
      Cell cell(cellDevice(device()), scene, volumes({{"counter", counter}}, {40, 40}));
      const float middle = cell.visibility()[0][4 * (20 * 40 + 20)];
      const bool wraps = std::string(counter) == "stencil8" && layers % 256 == 0;
      EXPECT_EQ(middle, wraps ? 1.0f : 0.0f) << layers << " " << counter;
    }
  }
}

GPU_TEST(ShadowVolumes, FiniteVolumesLackWhatTheChordCutsOff) {
  // A caster that the light sees under 60 degrees, at a reach of 10: its far end lies flat at
  // 10 cos 30 = 8.66, a chord's 1.34 short of the sphere.
  const auto at = [](double height) {
    Scene scene;
    const uint32_t grey = add(scene, matte());
    addHorizontal(scene, grey, {0, -float(height), 0}, 4, 4);
    addHorizontal(scene, grey, {0, -1, 0}, float(std::tan(glm::radians(30.0))), 0.05f);
    Light light = pointLight({0, 0, 0}, 100);
    light.range = 10;
    addLight(scene, light);
    scene.cameras.push_back(lookAt({6, 2 - height, 1}, {0, -height, 0}));
    return scene;
  };
  const auto wrong = [&](double height, const char* extrusion) {
    Cell cell(cellDevice(device()), at(height), volumes({{"extrusion", extrusion}}));
    return shadowMismatch(cell).elsewhere;
  };
  for (const double height : {8.0, 8.6, 8.75, 9.5}) {
    EXPECT_EQ(wrong(height, "infinite"), 0u) << height;
    EXPECT_EQ(wrong(height, "finite") > 0, height > 10 * std::cos(glm::radians(30.0))) << height;
  }
  // Lights without a range reach all that there is.
  Cell cell(cellDevice(device()), stage(true), volumes({{"extrusion", "finite"}}));
  expectExact(cell, "finite", 300);
}

GPU_TEST(ShadowVolumes, OneCountForAllLightsIsAnApproximation) {
  Cell multi(cellDevice(device()), stage(true), volumes());
  Cell single(cellDevice(device()), stage(true),
              volumes({{"lights", "single"}, {"darkness", "0.75"}}));
  // In any light's shadow every light is a quarter of itself.
  for (size_t i = 0; i < size_t(96) * 64; ++i) {
    float least = 1;
    for (const uint32_t light : multi.renderer().lights())
      least = std::min(least, multi.visibility(light)[0][4 * i]);
    if (multi.visibility(0)[0][4 * i + 3] == 0) continue;
    for (const uint32_t light : single.renderer().lights())
      ASSERT_EQ(single.visibility(light)[0][4 * i], least == 0 ? 0.25f : 1.0f) << i;
  }
  EXPECT_GT(shadowMismatch(single).elsewhere, 1000u);
}
