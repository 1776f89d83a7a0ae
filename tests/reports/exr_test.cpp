// Layers in one OpenEXR file, read back by a reader that is not ours; contact sheets.
#include "reports/exr.h"

#include <gtest/gtest.h>
#include <tinyexr.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "reports/contact_sheet.h"
#include "reports/picture.h"

namespace report {
namespace {

class Exr : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "exr-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::filesystem::path folder;
};

struct Read {
  std::vector<std::string> names;  ///< as the file has them
  std::map<std::string, std::vector<float>> planes;
  int width = 0, height = 0;
};

Read readExr(const std::filesystem::path& path) {
  EXRVersion version;
  EXRHeader header;
  EXRImage image;
  InitEXRHeader(&header);
  InitEXRImage(&image);
  const char* error = nullptr;
  const std::string file = path.string();
  EXPECT_EQ(ParseEXRVersionFromFile(&version, file.c_str()), TINYEXR_SUCCESS);
  EXPECT_EQ(ParseEXRHeaderFromFile(&header, &version, file.c_str(), &error), TINYEXR_SUCCESS);
  EXPECT_EQ(LoadEXRImageFromFile(&image, &header, file.c_str(), &error), TINYEXR_SUCCESS);
  Read out{{}, {}, image.width, image.height};
  for (int c = 0; c < header.num_channels; ++c) {
    EXPECT_EQ(header.pixel_types[c], TINYEXR_PIXELTYPE_FLOAT);
    const float* plane = reinterpret_cast<const float*>(image.images[c]);
    out.names.push_back(header.channels[c].name);
    out.planes[out.names.back()].assign(plane, plane + image.width * image.height);
  }
  FreeEXRImage(&image);
  FreeEXRHeader(&header);
  return out;
}

/// Values that tell layer, channel, column and row.
std::vector<float> marked(uint32_t width, uint32_t height, float layer) {
  std::vector<float> rgba;
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x)
      for (uint32_t c = 0; c < 4; ++c)
        rgba.push_back(layer * 1000 + float(c) * 100 + float(y) + float(x) / 64);
  return rgba;
}

TEST_F(Exr, LayersKeepTheirNamesAndValues) {
  constexpr uint32_t kWidth = 5, kHeight = 37;  // more than one block, the last one short
  std::map<std::string, std::vector<float>> given;
  std::vector<ExrLayer> layers;
  for (uint32_t i = 0; i < 12; ++i)
    given["light" + std::to_string(i) + ".opaque"] = marked(kWidth, kHeight, float(i));
  given[std::string(60, 'x')] = marked(kWidth, kHeight, 100);
  for (auto it = given.rbegin(); it != given.rend(); ++it)
    layers.push_back({it->first, it->second});
  writeExr(folder / "a.exr", kWidth, kHeight, layers);

  const Read read = readExr(folder / "a.exr");
  EXPECT_EQ(read.width, int(kWidth));
  EXPECT_EQ(read.height, int(kHeight));
  ASSERT_EQ(read.names.size(), 4 * given.size());
  EXPECT_TRUE(std::ranges::is_sorted(read.names));
  EXPECT_EQ(read.names[3], "light0.opaque.R");
  EXPECT_EQ(read.names[7], "light1.opaque.R");
  EXPECT_EQ(read.names[11], "light10.opaque.R");
  for (const auto& [name, rgba] : given)
    for (size_t c = 0; c < 4; ++c)
      for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x)
          ASSERT_EQ(read.planes.at(name + "." + "RGBA"[c])[(kHeight - 1 - y) * kWidth + x],
                    rgba[4 * (y * kWidth + x) + c])
              << name << c;
}

TEST_F(Exr, APictureHasNoLayer) {
  const Picture picture{3, 2, marked(3, 2, 0)};
  writeExr(folder / "p.exr", picture);
  const Read read = readExr(folder / "p.exr");
  EXPECT_EQ(read.names, (std::vector<std::string>{"A", "B", "G", "R"}));
  EXPECT_EQ(read.planes.at("G")[0], picture.rgba[4 * 3 + 1]);
}

TEST_F(Exr, WhatCannotBeWrittenLeavesNothing) {
  const std::vector<float> rgba = marked(1, 1, 0);
  const ExrLayer tooLong{std::string(300, 'x'), rgba}, good{"a", rgba};
  EXPECT_THROW(writeExr(folder / "l.exr", 1, 1, {&tooLong, 1}), std::runtime_error);
  EXPECT_THROW(writeExr(folder / "none" / "l.exr", 1, 1, {&good, 1}), std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(ContactSheet, HasItsCellsFromTheTopLeft) {
  const std::vector<float> red = {1, 0, 0, 1}, black = {0, 0, 0, 1}, nobody = {0, 0, 0, 0};
  const std::vector<std::span<const float>> cells = {red, black, nobody, {}};
  const Picture sheet = contactSheet(1, 1, cells, 2);
  EXPECT_EQ(sheet.width, 4u);  // a gap of two between columns
  EXPECT_EQ(sheet.height, 4u);
  const auto at = [&](uint32_t x, uint32_t fromTop) {
    const float* v = sheet.rgba.data() + 4 * ((sheet.height - 1 - fromTop) * sheet.width + x);
    return std::vector<float>(v, v + 3);
  };
  const std::vector<float> grey = at(1, 1);
  EXPECT_EQ(at(0, 0), (std::vector<float>{1, 0, 0}));
  EXPECT_EQ(at(3, 0), (std::vector<float>{0, 0, 0}));
  EXPECT_EQ(at(0, 3), grey);
  EXPECT_EQ(at(3, 3), grey);
  EXPECT_GT(grey[0], 0);
}

TEST(ContactSheet, ShrinksByMeansUntilItFits) {
  // Left half 1, right half 0; 30 of these would be 180 wide.
  std::vector<float> half;
  for (int i = 0; i < 16; ++i) half.insert(half.end(), {i % 4 < 2 ? 1.0f : 0.0f, 0, 0, 1});
  const std::vector<std::span<const float>> cells(30, half);
  const Picture sheet = contactSheet(4, 4, cells, 30, 120);
  EXPECT_EQ(sheet.width, 30u * 4 - 2);
  EXPECT_EQ(sheet.height, 2u);
  EXPECT_EQ(sheet.rgba[0], 1);
  EXPECT_EQ(sheet.rgba[4], 0);
}

}  // namespace
}  // namespace report
