// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "charts/threads_chart.hpp"

#include <gtest/gtest.h>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

Picture chart_of(const std::string& rows) {
  const test::Scratch folder;
  const std::string header = "loops,variables,threads,ns_per_step_variable,speed_up\n";
  return threads_chart(read_thread_times(folder.write("threads.csv", header + rows)), {"c"});
}

TEST(ThreadsChart, HasALineForEachNumberOfThreads) {
  const std::string script =
      chart_of("50,102,1,60,1.00\n50,102,2,90,0.67\n500,1002,1,50,1.00\n500,1002,2,40,1.25\n").script();
  for (const char* part : {"<< END\n102 0.67\n1002 1.25\nEND\n", "<< END\n102 90\n1002 40\nEND\n",
                           "title '1 thread'", "title '2 threads'"})
    EXPECT_NE(script.find(part), std::string::npos) << part;
}

TEST(ThreadsChart, RefusesATableWithoutRows) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"threads.csv", "no rows"}, [] { chart_of(""); }));
}

}  // namespace
}  // namespace tandem::charts
