// The exact text of the trade-offs on the console. After a change that is meant, replace the text
// here by what the failed test shows, and read the difference: the figures of the sweep are checked
// against values by hand in the other tests.
#include <gtest/gtest.h>

#include "reports/console/console_tradeoff.h"
#include "tests/reports/tradeoff_cells.h"

namespace report {
namespace {

/// A sweep with noise, one cell behind it, the baseline, the tracer, and a device with one cell.
report::Run sweep() {
  report::Run run;
  run.records = {baseline(2, 0.5),
                 cell("CSSM2", 4, 0.08, "1024"),
                 cell("CSSM2", 2.5, 0.2, "256"),
                 cell("CSSM2", 3, 0.1, "512"),
                 cell("ShadowMap", 3.25, 0.11, "512"),
                 tracer(40)};
  for (Record& r : run.records) spread(r, r.cpu->median / 8);
  noisy(run.records[1], 0.07, 0.0925);
  run.records[1].bytes = 40 << 20;
  Record card = cell("ShadowMap", 1, 0.0025);
  card.name = "ShadowMap/opengl/layers/64x32";
  card.id.backend = "opengl";
  card.device = "card";
  card.deviceType = "discrete";
  Record disturbed = baseline(1, 0.5);
  disturbed.contamination = {"other programs"};
  run.records.push_back(card);
  run.records.push_back(disturbed);
  return run;
}

TEST(TradeOffTable, IsExact) {
  const report::Run run = sweep();
  EXPECT_EQ("\n" + toTable(tradeOffs(run)), R"(
layers 64x32, vulkan: llvmpipe
  RMSE of visibility against CPU ms; without shadows 2.00
  cell                                    CPU ms         [95 %]  RMSE         [95 %]   MiB
  none/vulkan/layers/64x32                  2.00    [1.75,2.25]   0.5           none   1.0  front?
  CSSM2/vulkan/layers/size:256/64x32        2.50    [2.19,2.81]   0.2           none   1.0  front?
  CSSM2/vulkan/layers/size:512/64x32        3.00    [2.62,3.38]   0.1           none   1.0  front
  ShadowMap/vulkan/layers/size:512/64x32    3.25    [2.84,3.66]  0.11           none   1.0
  CSSM2/vulkan/layers/size:1024/64x32       4.00    [3.50,4.50]  0.08  [0.07,0.0925]  40.0  front
  RayTraced/cpu/layers/64x32               40.00  [35.00,45.00]     0           none   1.0  front

  least RMSE within  1 x none  2 x none  4 x none  8 x none  16 x none
  none                    0.5       0.5       0.5       0.5        0.5
  CSSM2                     -      0.08      0.08      0.08       0.08
  ShadowMap                 -      0.11      0.11      0.11       0.11
  RayTraced                 -         -         -         -          -

  least CPU ms at RMSE  <= 0.1  <= 0.03  <= 0.01  <= 0.003
  none                       -        -        -         -
  CSSM2                   3.00        -        -         -
  ShadowMap                  -        -        -         -
  RayTraced              40.00    40.00    40.00     40.00

  error ~ knob^-order  of    knob  at  order        [95 %]  points
  CSSM2                RMSE  size  -    0.66  [-1.83,3.15]       3

  none: no rate of exchange, 1 cell with error; 3 are needed
  CSSM2: halving the error costs 1.4 times the time (3 points, 0.23 to 8.0)
  ShadowMap: no rate of exchange, 1 cell with error; 3 are needed
  RayTraced: no error to halve

layers 64x32, opengl: card
  RMSE of visibility against frame ms; not measured without shadows
  cell                           frame ms  [95 %]    RMSE  [95 %]  MiB
  ShadowMap/opengl/layers/64x32      2.00    none  0.0025    none  1.0  front

  least frame ms at RMSE  <= 0.1  <= 0.03  <= 0.01  <= 0.003
  ShadowMap                 2.00     2.00     2.00      2.00

  ShadowMap: no rate of exchange, 1 cell with error; 3 are needed

front: no other cell here is as fast and as exact, and better in one.
front?: within the 95 % intervals of both, another may be.
)");
}

TEST(TradeOffTable, NamesTheImageWhenItsErrorIsMeant) {
  const report::Run run = {.records = {cell("A", 1, 0.5)}};
  EXPECT_EQ("\n" + toTable(tradeOffs(run, ErrorKind::Image)), R"(
layers 64x32, vulkan: llvmpipe
  RMSE of the image against CPU ms; not measured without shadows
  cell                   CPU ms  [95 %]  RMSE  [95 %]  MiB
  A/vulkan/layers/64x32    1.00    none  0.25    none  1.0  front

  least CPU ms at RMSE  <= 0.1  <= 0.03  <= 0.01  <= 0.003
  A                          -        -        -         -

  A: no rate of exchange, 1 cell with error; 3 are needed

front: no other cell here is as fast and as exact, and better in one.
)");
}

TEST(TradeOffTable, OfNothingIsEmpty) { EXPECT_EQ(toTable(std::vector<TradeOff>{}), ""); }

TEST(TradeOffTable, NeverSaysGpuOfASoftwareDevice) {
  const report::Run run = sweep();
  EXPECT_EQ(toTable(tradeOffs(run)).find("GPU"), std::string::npos);
}

}  // namespace
}  // namespace report
