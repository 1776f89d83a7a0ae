// Orders of convergence and rates of exchange. Times, errors and knobs are powers of two, so that
// their logarithms are whole and the slopes, and Student's t at one degree of freedom, can be
// worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "reports/stats/tradeoff.h"
#include "tests/reports/tradeoff_cells.h"

namespace report {
namespace {

TradeOff only(const report::Run& run) { return std::move(tradeOffs(run).at(0)); }

// t(1) = 12.7062 times the standard error 0.288675 of the slope of (0,0), (1,2), (2,3).
constexpr double kHalfWidth = 3.66797;

TEST(Convergence, OrderIsTheSlopeOfTheLogarithms) {
  // Logs to base 2: size 8, 9, 10, error 0, -2, -3.
  const report::Run run = {
      .records = {cell("A", 1, 1, "256"), cell("A", 1, 0.25, "512"), cell("A", 1, 0.125, "1024")}};
  const TradeOff t = only(run);
  ASSERT_EQ(t.orders.size(), 1u);
  EXPECT_EQ(t.orders[0].technique, "A");
  EXPECT_EQ(t.orders[0].knob, "size");
  EXPECT_EQ(t.orders[0].others, "");
  EXPECT_NEAR(t.orders[0].order, 1.5, 1e-12);
  EXPECT_NEAR(t.orders[0].interval.low, 1.5 - kHalfWidth, 1e-4);
  EXPECT_NEAR(t.orders[0].interval.high, 1.5 + kHalfWidth, 1e-4);
  EXPECT_EQ(t.orders[0].points, 3u);
}

TEST(Convergence, SeriesDifferInOneKnobAlone) {
  report::Run run;
  for (const char* kernel : {"1", "3"})
    for (const char* size : {"2", "4", "8"})
      for (uint32_t seed : {0u, 7u}) {
        Record r = cell("A", 1, 1 / std::pow(std::stod(size), std::stod(kernel)), size);
        r.knobs["kernel"] = kernel;
        r.knobs["filter"] = "box";
        r.id.seed = seed;
        run.records.push_back(r);
      }
  const TradeOff t = only(run);
  // Two kernels are too few for an order of their own.
  ASSERT_EQ(t.orders.size(), 4u);
  // The filter is the same everywhere: it says nothing.
  const std::string others[] = {"kernel:1", "kernel:1/seed:7", "kernel:3", "kernel:3/seed:7"};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(t.orders[i].knob, "size");
    EXPECT_EQ(t.orders[i].others, others[i]);
    EXPECT_EQ(t.orders[i].points, 3u);
    EXPECT_NEAR(t.orders[i].order, i < 2 ? 1 : 3, 1e-9);
    EXPECT_NEAR(t.orders[i].interval.low, i < 2 ? 1 : 3, 1e-6);
  }
}

TEST(Convergence, NoiseHasAnOrderOfItsOwn) {
  report::Run run;
  for (const int kernel : {1, 2, 4, 8}) {
    Record r = cell("A", 1, 0.5, std::to_string(kernel));
    r.noise = NoiseRecord{.seeds = 8, .noise = 0.25 / kernel, .rmseLow = 0.5, .rmseHigh = 0.5};
    run.records.push_back(r);
  }
  const TradeOff t = only(run);
  ASSERT_EQ(t.orders.size(), 2u);
  EXPECT_EQ(t.orders[0].of, "RMSE");
  EXPECT_NEAR(t.orders[0].order, 0, 1e-9);
  EXPECT_EQ(t.orders[1].of, "noise");
  EXPECT_NEAR(t.orders[1].order, 1, 1e-9);
  // Of the image no noise is known.
  const auto images = tradeOffs(run, ErrorKind::Image);
  for (const TradeOff& image : images)
    for (const Convergence& c : image.orders) EXPECT_EQ(c.of, "RMSE");
}

TEST(Convergence, NeedsThreeDifferentValuesWithLogarithms) {
  const Record a = cell("A", 1, 0.5, "2"), b = cell("A", 1, 0.25, "4");
  auto orders = [&](std::vector<Record> more) {
    const report::Run run = {.records = [&] {
      more.push_back(a);
      more.push_back(b);
      return more;
    }()};
    return only(run).orders.size();
  };
  EXPECT_EQ(orders({cell("A", 1, 0.125, "8")}), 1u);
  EXPECT_EQ(orders({}), 0u);
  EXPECT_EQ(orders({cell("A", 1, 0.125, "4")}), 0u) << "the same value twice";
  EXPECT_EQ(orders({cell("A", 1, 0, "8")}), 0u) << "no error";
  EXPECT_EQ(orders({cell("A", 1, 0.125, "0")}), 0u) << "zero";
  EXPECT_EQ(orders({cell("A", 1, 0.125, "8x8")}), 0u) << "not a number";
  EXPECT_EQ(orders({cell("B", 1, 0.125, "8")}), 0u) << "another technique";
  EXPECT_EQ(orders({cell("A", 1, 0.125)}), 0u) << "without the knob";
}

TEST(Exchange, FactorIsTheSlopeAlongTheOwnFront) {
  // Logs to base 2: error 0, -1, -2, time 0, 2, 3. The cell behind the front and the other
  // technique, which dominates all, do not count.
  const report::Run run = {.records = {cell("A", 1, 1), cell("A", 4, 0.5), cell("A", 8, 0.25),
                                       cell("A", 8, 0.75), cell("B", 0.5, 0.125)}};
  const TradeOff t = only(run);
  ASSERT_EQ(t.exchanges.size(), 2u);
  ASSERT_TRUE(t.exchanges[0].factor);
  EXPECT_NEAR(*t.exchanges[0].factor, std::sqrt(8), 1e-9);
  // 2^(1.5 - 3.668) and 2^(1.5 + 3.668).
  EXPECT_EQ(t.exchanges[0].text,
            "A: halving the error costs 2.8 times the time (3 points, 0.22 to 36)");
  EXPECT_FALSE(t.exchanges[1].factor);
}

TEST(Exchange, TextNeverPretendsToKnowWhatLiesFarOutside) {
  const report::Run run = {.records = {cell("A", 1, 1), cell("A", 64, 0.5), cell("A", 65, 0.25)}};
  EXPECT_EQ(only(run).exchanges.at(0).text,
            "A: halving the error costs 8.1 times the time (3 points, under 0.01 to over 1000)");
}

TEST(Exchange, IsAbsentWithTheReason) {
  auto text = [](std::vector<Record> records) {
    const report::Run run = {.records = std::move(records)};
    const TradeOff t = only(run);
    EXPECT_FALSE(t.exchanges.at(0).factor);
    return t.exchanges.at(0).text;
  };
  EXPECT_EQ(text({tracer(1)}), "RayTraced: no error to halve");
  EXPECT_EQ(text({cell("A", 1, 0.5)}), "A: no rate of exchange, 1 cell with error; 3 are needed");
  EXPECT_EQ(text({cell("A", 1, 0.5), cell("A", 2, 0.25), cell("A", 3, 0)}),
            "A: no rate of exchange, 2 cells with error; 3 are needed");
  EXPECT_EQ(text({cell("A", 1, 0.25), cell("A", 2, 0.5), cell("A", 3, 0.75)}),
            "A: no rate of exchange, 1 of 3 cells with error on its own front; 3 are needed");
  EXPECT_EQ(text({cell("A", 1, 0.25), cell("A", 2, 0.125), cell("A", 3, 0.75)}),
            "A: no rate of exchange, 2 of 3 cells with error on its own front; 3 are needed");
  EXPECT_EQ(text({cell("A", 1, 0.25), cell("A", 1, 0.25), cell("A", 1, 0.25)}),
            "A: no rate of exchange, 1 of 3 cells with error on its own front; 3 are needed")
      << "the same point thrice";
  EXPECT_EQ(text({cell("A", 1, 0), cell("A", 2, 0.5), cell("A", 3, 0.25), cell("A", 4, 0.1)}),
            "A: no rate of exchange, 0 of 3 cells with error on its own front; 3 are needed");
}

}  // namespace
}  // namespace report
