// Flags of Google Benchmark: every spelling that it documents, and nothing else.
#include <gtest/gtest.h>

#include "suites/harness/measuring/gbench.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

BenchmarkFlags flags(const std::string& argument) {
  std::vector<std::string> arguments = {argument};
  return takeBenchmarkFlags(arguments);
}

TEST(BenchmarkFlags, TimesAndRepetitions) {
  EXPECT_EQ(flags("--benchmark_min_time=0.2").minSeconds, 0.2);
  EXPECT_EQ(flags("--benchmark_min_time=0.2s").minSeconds, 0.2);
  EXPECT_EQ(flags("--benchmark_min_time=5x").repetitions, 5u);
  EXPECT_EQ(flags("--benchmark_repetitions=7").repetitions, 7u);
  for (const char* bad :
       {"min_time=1e400", "min_time=inf", "min_time=nan", "min_time=0", "min_time=-1", "min_time=",
        "min_time=5y", "min_time=0.5x", "min_time=x", "min_time=s", "min_time=1e300", "min_time",
        "repetitions=0", "repetitions=0.5", "repetitions=1e300", "repetitions=4294967297",
        "repetitions=5x", "format=xml", "format=", "out_format=html", "out=", "color=blue",
        "list_tests=maybe", "counters_tabular=3"})
    EXPECT_THROW(flags(std::string("--benchmark_") + bad), InputError) << bad;
}

TEST(BenchmarkFlags, FiltersAndOutputs) {
  EXPECT_EQ(flags("--benchmark_filter=all").filter, "");
  EXPECT_TRUE(flags("--benchmark_filter=-a").filterExcludes);
  EXPECT_EQ(flags("--benchmark_out=x.json").outFile, "x.json");
  EXPECT_TRUE(flags("--benchmark_format=json").display);
  EXPECT_TRUE(flags("--benchmark_list_tests").list);
  EXPECT_FALSE(flags("--benchmark_list_tests=No").list);
}

}  // namespace
}  // namespace sb
